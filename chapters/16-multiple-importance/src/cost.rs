//! What accuracy costs in time.

mod lobes;
mod neighbours;
mod part_four;
mod plates;
mod sight;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let scenes = [plates::experiment(), neighbours::experiment(), part_four::experiment()];
    std::iter::once(lobes::experiment()).chain(scenes.into_iter().flatten()).collect()
}
