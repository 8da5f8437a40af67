//! What finding triangles costs: in time, by the number of cells and by structure, and to build.

mod build;
mod cells;
pub mod sight;
mod structures;

use common::cost::Experiment;
use triangles::bunny::bunny;
use triangles::convert::Normals;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let mesh = bunny(Normals::Flat).unwrap_or_default();
    let corners = mesh.all_corners();
    vec![
        cells::experiment(&corners),
        structures::bunny(corners),
        structures::growth(),
        build::experiment(),
    ]
}
