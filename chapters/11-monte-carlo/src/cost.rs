//! What accuracy costs in time.

mod edge;
mod powers;
mod sky;
mod variances;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    vec![sky::experiment(), edge::experiment(), powers::experiment(), variances::experiment()]
}
