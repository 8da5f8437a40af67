//! What accuracy costs in time.

mod near;
mod pictures;
mod plan;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let pictures =
        [pictures::looking(), pictures::ball(), pictures::choosing(), plan::experiment()];
    let [looking, ball, choosing, plan] = pictures;
    [looking, Some(near::experiment()), ball, choosing, plan].into_iter().flatten().collect()
}
