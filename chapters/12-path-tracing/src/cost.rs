//! What accuracy costs in time.

mod branching;
mod by_hand;
mod plan;
mod truncation;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    [branching::experiment(), truncation::experiment(), plan::experiment()]
        .into_iter()
        .flatten()
        .collect()
}
