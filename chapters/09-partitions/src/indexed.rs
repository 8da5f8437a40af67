//! A mesh with an accelerator: a shape that any scene can hold.

use common::tally::{Counts, Off};
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use triangles::mesh::Mesh;

use crate::accelerator::Accelerator;

// ANCHOR: indexed
/// A mesh whose triangles are found by `A`.
pub struct Indexed<A> {
    mesh: Mesh,
    accelerator: A,
}

impl<A: Accelerator + 'static> Indexed<A> {
    /// The mesh with its accelerator.
    pub fn new(mesh: Mesh) -> Self {
        let accelerator = A::build(mesh.all_corners());
        Self { mesh, accelerator }
    }

    /// The same as a shape: `Indexed::<Grid>::shape` is a `fn(Mesh) -> Box<dyn Shape>`.
    pub fn shape(mesh: Mesh) -> Box<dyn Shape> {
        Box::new(Self::new(mesh))
    }
}

impl<A: Accelerator> Shape for Indexed<A> {
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let found = self.accelerator.nearest(ray, t_max, &mut Off)?;
        Some(self.mesh.complete(found))
    }

    fn is_hit(&self, ray: &Ray, t_max: f32) -> bool {
        self.accelerator.is_hit(ray, t_max, &mut Off)
    }

    fn is_hit_counted(&self, ray: &Ray, t_max: f32, counts: &mut Counts) -> bool {
        self.accelerator.is_hit(ray, t_max, counts)
    }

    fn hit_counted(&self, ray: &Ray, t_max: f32, counts: &mut Counts) -> Option<Hit> {
        let found = self.accelerator.nearest(ray, t_max, counts)?;
        Some(self.mesh.complete(found))
    }
}
// ANCHOR_END: indexed

#[cfg(test)]
mod tests {
    use common::tally::Counts;
    use glam::Vec3;
    use ray_casting::ray::Ray;
    use ray_casting::shape::Shape;
    use triangles::brute::TRIANGLE_TESTS;
    use triangles::bumpy;

    use super::Indexed;
    use crate::scan::Scan;

    #[test]
    fn the_shape_answers_as_the_mesh_does() {
        let mesh = bumpy::sphere(300);
        let shape: fn(_) -> Box<dyn Shape> = Indexed::<Scan>::shape;
        let shape = shape(mesh.clone());
        let ray = Ray { origin: Vec3::new(0.3, 0.1, 4.0), direction: Vec3::NEG_Z };
        let hit = mesh.hit(&ray, f32::INFINITY).expect("the sphere is there");
        assert_eq!(shape.hit(&ray, f32::INFINITY), Some(hit));
        assert!(shape.is_hit(&ray, f32::INFINITY) && !shape.is_hit(&ray, hit.t));
        let mut counts = Counts::default();
        assert_eq!(shape.hit_counted(&ray, f32::INFINITY, &mut counts), Some(hit));
        assert_eq!(counts.of(TRIANGLE_TESTS), 300);
    }
}
