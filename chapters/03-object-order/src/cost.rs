//! What each order costs against triangles and pixels, and what exact edges and clipping cost.

mod clipping;
mod crossing;
mod edges;
mod orders;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    vec![orders::triangles(), orders::pixels(), edges::experiment(), clipping::experiment()]
}
