//! What accuracy costs here is nothing: every method finds the same hits. What differs is the time.

mod growth;
mod splits;
mod traversals;

use common::cost::Experiment;
use triangles::bunny::bunny;
use triangles::convert::Normals;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let corners = bunny(Normals::Flat).map(|mesh| mesh.all_corners());
    let on_the_bunny = corners.ok().into_iter().flat_map(|corners| {
        [traversals::experiment(&corners), splits::tracing(&corners), splits::building(&corners)]
    });
    on_the_bunny.chain([growth::experiment()]).collect()
}
