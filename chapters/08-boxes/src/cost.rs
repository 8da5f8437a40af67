//! What accuracy costs: slab tests against their wrong answers, and boxes against none.

mod bunny;
mod forms;
mod padding;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let boxes = bunny::experiment();
    [forms::in_plane(), forms::zeros(), padding::experiment()].into_iter().chain(boxes).collect()
}
