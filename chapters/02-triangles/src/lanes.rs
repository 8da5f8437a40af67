//! Four triangles at once: the watertight test on a layout the processor likes.
//!
//! A processor does one operation on four `f32` as fast as on one, if the four lie side by side. So
//! the corners of four triangles are stored coordinate by coordinate. The arithmetic is that of
//! [`ShearedRay`], operation by operation, so the answers are the same to the last bit.

use glam::{Vec3, Vec4};
use ray_casting::ray::Ray;

use crate::brute::Found;
use crate::intersect::TriangleTest;
use crate::watertight::ShearedRay;

/// How many triangles are asked together: a [`Vec4`] has one number for each.
pub const LANES: usize = 4;

// ANCHOR: pack
/// Up to four triangles that are asked together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pack {
    /// The four triangles' corners a, then b, then c: of each the four x, the four y, the four z.
    corners: [[Vec4; 3]; 3],
}

/// Many triangles, ready to be asked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Packed {
    packs: Vec<Pack>,
    corners: Vec<[Vec3; 3]>,
}
// ANCHOR_END: pack

impl Packed {
    /// The same triangles in the same order.
    pub fn new(corners: Vec<[Vec3; 3]>) -> Self {
        Self { packs: corners.chunks(LANES).map(Pack::new).collect(), corners }
    }

    /// How many triangles there are.
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// The corners, triangle by triangle.
    pub fn corners(&self) -> &[[Vec3; 3]] {
        &self.corners
    }

    // ANCHOR: nearest
    /// The nearest hit with `0 < t < t_max`: what [`crate::brute::nearest`] finds, to the bit.
    pub fn nearest(&self, ray: &Ray, t_max: f32) -> Option<Found> {
        let ray = ShearedRay::prepare(ray)?;
        let four_rays = FourRays::new(&ray);
        let mut nearest = None;
        let mut limit = t_max;
        for (pack, first) in self.packs.iter().zip((0..).step_by(LANES)) {
            if pack.candidates(&four_rays) == 0 {
                continue;
            }
            for (index, corners) in (first..).zip(self.corners[first..].iter().take(LANES)) {
                if let Some(hit) = ray.hit(corners, limit) {
                    limit = hit.t;
                    nearest = Some(Found { hit, index });
                }
            }
        }
        nearest
    }
    // ANCHOR_END: nearest

    /// The first triangle in the list, not along the ray, that is hit at `0 < t < t_max`.
    pub fn first_hit(&self, ray: &Ray, t_max: f32) -> Option<usize> {
        let ray = ShearedRay::prepare(ray)?;
        let four_rays = FourRays::new(&ray);
        let packs = self.packs.iter().zip((0..).step_by(LANES));
        packs.filter(|(pack, _)| pack.candidates(&four_rays) != 0).find_map(|(_, first)| {
            let four = (first..).zip(self.corners[first..].iter().take(LANES));
            four.into_iter().find(|(_, it)| ray.hit(it, t_max).is_some()).map(|(index, _)| index)
        })
    }
}

impl Pack {
    /// The first [`LANES`] of these triangles, of which there must be one; where there are fewer,
    /// the first fills the rest.
    pub fn new(triangles: &[[Vec3; 3]]) -> Self {
        let lane = |lane: usize| triangles.get(lane).unwrap_or(&triangles[0]);
        let four =
            |corner: usize, axis: usize| Vec4::from([0, 1, 2, 3].map(|at| lane(at)[corner][axis]));
        let corners = [0, 1, 2].map(|corner| [0, 1, 2].map(|axis| four(corner, axis)));
        Self { corners }
    }

    /// The corners of one of the triangles.
    #[inline]
    pub fn triangle(&self, lane: usize) -> [Vec3; 3] {
        self.corners.map(|corner| Vec3::from(corner.map(|four| four[lane])))
    }

    /// The corners of one of the triangles in the ray's coordinates, as [`ShearedRay::measure`]
    /// wants them.
    #[inline]
    pub fn sheared(&self, lane: usize, ray: &FourRays) -> [Vec3; 3] {
        let [a, b, c] = &self.corners;
        [ray.shear_one(a, lane), ray.shear_one(b, lane), ray.shear_one(c, lane)]
    }

    // ANCHOR: candidates
    /// The triangles that the ray may hit, a bit for each, the lowest for the first. Of the others
    /// edge functions of different signs prove that it misses them.
    #[inline]
    pub fn candidates(&self, ray: &FourRays) -> u32 {
        let [a, b, c] = &self.corners;
        let (a, b, c) = (ray.shear(a), ray.shear(b), ray.shear(c));
        let (u, v, w) = (edge(&b, &c), edge(&c, &a), edge(&a, &b));
        let negative = u.cmplt(Vec4::ZERO) | v.cmplt(Vec4::ZERO) | w.cmplt(Vec4::ZERO);
        let positive = u.cmpgt(Vec4::ZERO) | v.cmpgt(Vec4::ZERO) | w.cmpgt(Vec4::ZERO);
        (!(negative & positive)).bitmask()
    }
    // ANCHOR_END: candidates
}

/// One ray, in each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourRays {
    order: [usize; 3],
    origin: [Vec4; 3],
    shear: [Vec4; 2],
}

/// Four points in the plane across the ray, one of each triangle.
struct FourPoints {
    x: Vec4,
    y: Vec4,
}

impl FourRays {
    /// The ray four times.
    #[inline]
    pub fn new(ray: &ShearedRay) -> Self {
        let order = ray.longest.order();
        let [i, j, k] = order;
        let splat = |axis: usize| Vec4::splat(ray.origin[axis]);
        let origin = [splat(i), splat(j), splat(k)];
        let shear = [Vec4::splat(ray.shear.x), Vec4::splat(ray.shear.y)];
        Self { order, origin, shear }
    }

    /// What [`Self::shear`] does, for one lane.
    #[inline]
    fn shear_one(&self, corner: &[Vec4; 3], lane: usize) -> Vec3 {
        let [i, j, k] = self.order;
        let x = corner[i].as_ref()[lane] - self.origin[0].x;
        let y = corner[j].as_ref()[lane] - self.origin[1].x;
        let depth = corner[k].as_ref()[lane] - self.origin[2].x;
        Vec3::new(x - self.shear[0].x * depth, y - self.shear[1].x * depth, depth)
    }

    #[inline]
    fn shear(&self, corner: &[Vec4; 3]) -> FourPoints {
        let [i, j, k] = self.order;
        let depth = corner[k] - self.origin[2];
        FourPoints {
            x: (corner[i] - self.origin[0]) - self.shear[0] * depth,
            y: (corner[j] - self.origin[1]) - self.shear[1] * depth,
        }
    }
}

#[inline]
fn edge(p: &FourPoints, q: &FourPoints) -> Vec4 {
    p.x * q.y - p.y * q.x
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::{FourRays, Pack, Packed};
    use crate::brute::nearest;
    use crate::bumpy;
    use crate::hard::aimed::NEAR;
    use crate::intersect::TriangleTest;
    use crate::watertight::ShearedRay;

    #[test]
    fn four_at_a_time_finds_what_one_at_a_time_does() {
        for (mesh, trials) in NEAR.iter().zip([4000, 2000, 500]) {
            // Sizes that four divides, and sizes that leave one, two and three over.
            for left_out in 0..4 {
                let corners = mesh.corners[left_out..].to_vec();
                let packed = Packed::new(corners.clone());
                for trial in 0..trials / 4 {
                    let mut stream = Stream::of_trial(left_out as u64, trial);
                    let aim = mesh.at_edge(&mut stream).expect("an edge is not at the middle");
                    let one = nearest::<ShearedRay>(&corners, &aim.ray, f32::INFINITY);
                    assert_eq!(packed.nearest(&aim.ray, f32::INFINITY), one);
                }
            }
        }
    }

    #[test]
    fn one_of_four_is_the_triangle_it_was() {
        let corners = bumpy::sphere(96).all_corners();
        let ray = Ray { origin: Vec3::new(0.1, 0.2, 0.3), direction: Vec3::new(-2.0, 0.5, 1.0) };
        let sheared = ShearedRay::prepare(&ray).expect("an ordinary ray");
        let four_rays = FourRays::new(&sheared);
        for four in corners.chunks(4) {
            let pack = Pack::new(four);
            for (lane, corners) in four.iter().enumerate() {
                assert_eq!(pack.triangle(lane), *corners);
                let hit = sheared.hit(corners, f32::INFINITY);
                let candidate = pack.candidates(&four_rays) >> lane & 1 == 1;
                assert!(candidate || hit.is_none());
                let measured = sheared.measure(pack.sheared(lane, &four_rays), f32::INFINITY);
                assert_eq!(measured.map(|measured| measured.hit()), hit);
            }
        }
    }

    #[test]
    fn no_triangles_no_hit_and_no_direction_no_hit() {
        let ray = Ray { origin: Vec3::ZERO, direction: Vec3::X };
        assert_eq!(Packed::new(Vec::new()).nearest(&ray, f32::INFINITY), None);
        let packed = Packed::new(bumpy::sphere(30).all_corners());
        assert!(packed.nearest(&ray, f32::INFINITY).is_some());
        assert!(packed.nearest(&ray, f32::NAN).is_none());
        let nowhere = Ray { direction: Vec3::ZERO, ..ray };
        assert_eq!(packed.nearest(&nowhere, f32::INFINITY), None);
    }
}
