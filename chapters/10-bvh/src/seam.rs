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

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use ray_casting::ray::Ray;
    use ray_casting::shape::Shape;
    use triangles::bumpy;

    use super::accelerated;

    #[test]
    fn a_mesh_answers_as_before() {
        let mesh = bumpy::sphere(500);
        let shape = accelerated(mesh.clone());
        let ray = Ray { origin: Vec3::new(0.1, 0.2, 0.3), direction: Vec3::new(-1.0, 0.5, 2.0) };
        let hit = mesh.hit(&ray, f32::INFINITY).expect("the ray starts inside");
        assert_eq!(shape.hit(&ray, f32::INFINITY), Some(hit));
        assert!(shape.is_hit(&ray, f32::INFINITY) && !shape.is_hit(&ray, hit.t));
    }
}
