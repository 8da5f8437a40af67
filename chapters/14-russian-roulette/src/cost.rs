//! What accuracy costs in time.

mod abreast;
mod depth;
mod sight;
mod survival;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    [survival::experiment(), depth::experiment(), abreast::experiment()]
        .into_iter()
        .flatten()
        .collect()
}
