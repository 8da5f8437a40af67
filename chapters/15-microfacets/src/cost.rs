//! What accuracy costs in time.

mod lost;
mod normals;
mod plan;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let experiments = [Some(normals::experiment()), Some(lost::experiment()), plan::experiment()];
    experiments.into_iter().flatten().collect()
}
