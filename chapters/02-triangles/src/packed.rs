//! A mesh that is asked four triangles at a time.

use common::tally::{Counts, Tally};
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};

use crate::brute::TRIANGLE_TESTS;
use crate::lanes::Packed;
use crate::mesh::Mesh;

// ANCHOR: packed
/// A mesh as a shape: every ray asks each of its triangles, [`LANES`](crate::lanes::LANES) at once.
///
/// It answers as the [`Mesh`] itself does, to the bit, only sooner.
#[derive(Clone, Debug)]
pub struct PackedMesh {
    mesh: Mesh,
    packed: Packed,
}
// ANCHOR_END: packed

impl PackedMesh {
    /// The mesh, ready to be asked.
    pub fn new(mesh: Mesh) -> Self {
        Self { packed: Packed::new(mesh.all_corners()), mesh }
    }
}

impl Shape for PackedMesh {
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        self.packed.nearest(ray, t_max).map(|found| self.mesh.complete(found))
    }

    fn hit_counted(&self, ray: &Ray, t_max: f32, counts: &mut Counts) -> Option<Hit> {
        counts.count(TRIANGLE_TESTS, self.packed.len() as u64);
        self.hit(ray, t_max)
    }

    /// Whether any triangle is hit; those after it are not asked.
    fn is_hit(&self, ray: &Ray, t_max: f32) -> bool {
        self.packed.first_hit(ray, t_max).is_some()
    }

    fn is_hit_counted(&self, ray: &Ray, t_max: f32, counts: &mut Counts) -> bool {
        let first = self.packed.first_hit(ray, t_max);
        let asked = first.map_or(self.packed.len(), |index| index + 1);
        counts.count(TRIANGLE_TESTS, asked as u64);
        first.is_some()
    }
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use common::tally::Counts;
    use glam::Vec3;
    use ray_casting::ray::Ray;
    use ray_casting::shape::Shape;

    use super::PackedMesh;
    use crate::brute::TRIANGLE_TESTS;
    use crate::bumpy;

    #[test]
    fn it_answers_as_the_mesh_does() {
        let mesh = bumpy::sphere(130);
        let packed = PackedMesh::new(mesh.clone());
        for trial in 0..2000 {
            let mut stream = Stream::of_trial(31, trial);
            let mut place = |side: f32| {
                let mut component = || stream.between(-side, side);
                Vec3::new(component(), component(), component())
            };
            let origin = place(3.0);
            let ray = Ray { origin, direction: place(0.9) - origin };
            for t_max in [f32::INFINITY, 0.7] {
                assert_eq!(packed.hit(&ray, t_max), mesh.hit(&ray, t_max), "{ray:?}");
                let [fast, slow] = [&packed as &dyn Shape, &mesh].map(|shape| {
                    let mut counts = Counts::default();
                    let hit = shape.is_hit_counted(&ray, t_max, &mut counts);
                    (hit, shape.is_hit(&ray, t_max), counts.of(TRIANGLE_TESTS))
                });
                assert_eq!(fast, slow, "{ray:?}");
                assert_eq!((fast.0, fast.1), (fast.1, mesh.hit(&ray, t_max).is_some()));
            }
        }
    }

    #[test]
    fn every_triangle_is_counted() {
        let packed = PackedMesh::new(bumpy::sphere(130));
        let mut counts = Counts::default();
        let ray = Ray { origin: Vec3::splat(9.0), direction: Vec3::X };
        assert_eq!(packed.hit_counted(&ray, f32::INFINITY, &mut counts), None);
        assert_eq!(counts.of(TRIANGLE_TESTS), 130);
    }
}
