//! The seam: what later chapters make their meshes into.

use partitions::indexed::Indexed;
use ray_casting::shape::Shape;
use triangles::mesh::Mesh;

use crate::packed::PackedBvh;

// ANCHOR: accelerated
/// A mesh as a shape whose triangles are found by a tree: what chapters after this one hand to the
/// scenes of those before it (their `mesh_shape`). A better tree can take its place here, and none
/// of them will notice, but for the time.
pub fn accelerated(mesh: Mesh) -> Box<dyn Shape> {
    Indexed::<PackedBvh>::shape(mesh)
}
// ANCHOR_END: accelerated
