//! What accuracy costs in nanoseconds, what a shorter question saves, and what the plan does.

mod offsets;
mod plans;
mod questions;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let mut experiments = vec![offsets::experiment(), questions::experiment()];
    experiments.extend(plans::experiment().ok());
    experiments
}
