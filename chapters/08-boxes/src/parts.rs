//! A mesh in parts, each behind a box: the triangles are asked only when the box is met.

use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::brute::{Found, TRIANGLE_TESTS};
use triangles::lanes::Packed;

use crate::aabb::Aabb;
use crate::bounded::Bounded;
use crate::slab::{BOX_TESTS, BoxRay};

// ANCHOR: parts
/// Triangles in runs of equal length, in the order of the file.
pub struct Parts {
    bounds: Aabb,
    parts: Vec<Part>,
}

/// A run of triangles, and the box around it.
struct Part {
    bounds: Aabb,
    first: usize,
    triangles: Packed,
}
// ANCHOR_END: parts

impl Parts {
    /// The triangles in `count` runs, or fewer when there are not as many triangles.
    pub fn new(corners: &[[Vec3; 3]], count: usize) -> Self {
        let length = corners.len().div_ceil(count.max(1)).max(1);
        let starts = (0..).step_by(length);
        let parts: Vec<Part> =
            corners.chunks(length).zip(starts).map(|(run, first)| Part::new(run, first)).collect();
        let bounds = parts.iter().map(|part| part.bounds).fold(Aabb::EMPTY, Aabb::union);
        Self { bounds, parts }
    }

    /// The box around all triangles.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The boxes of the parts.
    pub fn boxes(&self) -> impl Iterator<Item = &Aabb> {
        self.parts.iter().map(|part| &part.bounds)
    }

    // ANCHOR: nearest
    /// The nearest hit with `0 < t < t_max`: what chapter 2's brute force finds, to the bit.
    ///
    /// A box that is entered beyond the hit found so far holds nothing nearer.
    pub fn nearest<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> Option<Found> {
        let box_ray = BoxRay::new(ray, &self.bounds);
        let mut nearest = None;
        let mut limit = t_max;
        for part in &self.parts {
            tally.count(BOX_TESTS, 1);
            if box_ray.enter(&part.bounds, limit).is_none() {
                continue;
            }
            tally.count(TRIANGLE_TESTS, part.triangles.len() as u64);
            if let Some(Found { hit, index }) = part.triangles.nearest(ray, limit) {
                limit = hit.t;
                nearest = Some(Found { hit, index: part.first + index });
            }
        }
        nearest
    }
    // ANCHOR_END: nearest
}

impl Part {
    fn new(run: &[[Vec3; 3]], first: usize) -> Self {
        let bounds = run.iter().map(Bounded::bounds).fold(Aabb::EMPTY, Aabb::union);
        Self { bounds, first, triangles: Packed::new(run.to_vec()) }
    }
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use common::tally::{Counts, Off};
    use glam::Vec3;
    use ray_casting::ray::Ray;
    use triangles::brute::TRIANGLE_TESTS;
    use triangles::bumpy;
    use triangles::lanes::Packed;

    use super::Parts;
    use crate::slab::BOX_TESTS;

    const FAR: f32 = f32::INFINITY;

    fn point(stream: &mut Stream, side: f32) -> Vec3 {
        let mut component = || stream.between(-side, side);
        Vec3::new(component(), component(), component())
    }

    /// Whatever the number of boxes, each ray finds the same triangle at the same t.
    #[test]
    fn boxes_change_no_bit() {
        let corners = bumpy::sphere(600).all_corners();
        let brute = Packed::new(corners.clone());
        let mut hits = 0;
        for count in [1, 2, 7, 64, 600, 5000] {
            let parts = Parts::new(&corners, count);
            for trial in 0..2000 {
                let mut stream = Stream::of_trial(821, trial);
                let origin = point(&mut stream, 3.0);
                let aim = match trial % 3 {
                    0 => corners[trial as usize % corners.len()][0],
                    _ => point(&mut stream, 1.2),
                };
                let ray = Ray { origin, direction: aim - origin };
                let found = parts.nearest(&ray, FAR, &mut Off);
                assert_eq!(found, brute.nearest(&ray, FAR), "{count} boxes, ray {trial}");
                hits += u32::from(found.is_some());
            }
        }
        assert!(hits > 6000, "{hits}");
    }

    #[test]
    fn a_box_that_is_missed_saves_its_triangles() {
        let parts = Parts::new(&bumpy::sphere(600).all_corners(), 1);
        let count = |origin: Vec3| {
            let mut counts = Counts::default();
            parts.nearest(&Ray { origin, direction: Vec3::NEG_Z }, FAR, &mut counts);
            (counts.of(BOX_TESTS), counts.of(TRIANGLE_TESTS))
        };
        assert_eq!(count(Vec3::new(0.1, 0.2, 5.0)), (1, 600));
        assert_eq!(count(Vec3::new(0.1, 7.0, 5.0)), (1, 0));
    }

    #[test]
    fn no_triangles_no_boxes_and_one_triangle_one() {
        let ray = Ray { origin: Vec3::ZERO, direction: Vec3::X };
        let none = Parts::new(&[], 3);
        assert!(none.bounds().is_empty() && none.boxes().next().is_none());
        assert_eq!(none.nearest(&ray, FAR, &mut Off), None);
        let one = Parts::new(&[[Vec3::X, Vec3::X + Vec3::Y, Vec3::X - Vec3::Y + Vec3::Z]], 3);
        assert_eq!(one.boxes().count(), 1);
        assert!(one.nearest(&ray, FAR, &mut Off).is_some_and(|found| found.hit.t == 1.0));
    }

    #[test]
    fn triangles_of_nan_are_no_trouble() {
        let good = [Vec3::X, Vec3::X + Vec3::Y, Vec3::X - Vec3::Y + Vec3::Z];
        let ray = Ray { origin: Vec3::ZERO, direction: Vec3::X };
        for count in [1, 2, 3] {
            let parts = Parts::new(&[[Vec3::NAN; 3], good, [Vec3::INFINITY; 3]], count);
            let found = parts.nearest(&ray, FAR, &mut Off).expect("the good one");
            assert_eq!((found.index, found.hit.t), (1, 1.0));
        }
    }
}
