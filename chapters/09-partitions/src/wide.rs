//! A ray with a width: as wide as what roundings can do to a hit.
//!
//! The watertight test rounds a triangle's corners into the ray's coordinates, so it may hit a
//! triangle that the exact ray passes by a hair: in another cell than the one the ray is in. Cells
//! are therefore not asked whether the ray meets them, but whether the ray comes so near to them
//! that it could hit what they hold.

use boxes::aabb::Aabb;
use boxes::slab::PAD;
use glam::Vec3;
use ray_casting::ray::Ray;

// ANCHOR: width
/// Half the ray's width, as a part of the distance from its origin to the farthest corner of the
/// scene, along any axis: 32 u, where u is 2⁻²⁴.
///
/// 4 u for how far beside the exact ray the triangle test may hit, 2 u for the two differences to the
/// borders (see chapter 8 for both), and 2 u for its `t` and the product with the direction. 6 u for
/// where the ray crosses a plane: two differences, a slope, its inverse, a product. 12 u for the
/// borders of a grid, which are rounded, and for [`crate::cells::Side::index`], which rounds
/// otherwise. That makes 26; a tree takes less.
pub const WIDTH: f32 = 2.0 * PAD;
// ANCHOR_END: width

// ANCHOR: wide_ray
/// A ray that covers all points within its width of the exact one, along each axis.
///
/// A place on it is named by how far it is along the axis on which the ray runs fastest, whatever
/// the length of the direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WideRay {
    origin: Vec3,
    /// What the other coordinates gain for each unit along the longest axis: within [-1, 1].
    slope: Vec3,
    width: f32,
    /// Units along the longest axis for each unit of `t`.
    longest: f32,
}

impl WideRay {
    /// The finite `ray`, which has a direction, among triangles within `bounds`.
    pub fn new(ray: &Ray, bounds: &Aabb) -> Self {
        let (below, above) = (bounds.min - ray.origin, bounds.max - ray.origin);
        let farthest = below.abs().max(above.abs()).max_element();
        // Where products are too small for f32 their errors are no longer a part of anything.
        Self::of_width(ray, WIDTH * farthest + f32::MIN_POSITIVE)
    }
    // ANCHOR_END: wide_ray

    /// The same with a width of the caller's choice.
    pub(crate) fn of_width(ray: &Ray, width: f32) -> Self {
        let Ray { origin, direction } = *ray;
        let longest = direction.abs().max_element();
        Self { origin, slope: direction / longest, width, longest }
    }

    // ANCHOR: reach
    /// How far along the longest axis a hit at `t` is at most; always finite. Between `t` and this
    /// distance lie a rounding in each of three products, and what is too small to be rounded.
    #[inline]
    pub fn reach(&self, t: f32) -> f32 {
        let distance = t * self.longest * (1.0 + 2.0 * f32::EPSILON) + f32::MIN_POSITIVE;
        distance.min(f32::MAX)
    }
    // ANCHOR_END: reach

    /// The part of the ray in which it can hit what is within `bounds`, at a `t` up to `t_max`.
    pub fn within(&self, bounds: &Aabb, t_max: f32) -> Interval {
        let all = Interval { from: 0.0, to: self.reach(t_max) };
        (0..3).fold(all, |part, axis| {
            let track = self.track(axis);
            part.above(&track, bounds.min[axis]).below(&track, bounds.max[axis])
        })
    }

    /// What it does along one axis.
    #[inline]
    pub fn track(&self, axis: usize) -> Track {
        Track::new(self.origin[axis], self.slope[axis], self.width)
    }

    /// What it does along the direction `normal`, which needs no length of 1, from `base`.
    #[inline]
    pub fn track_along(&self, normal: Vec3, base: Vec3) -> Track {
        let width = self.width * normal.abs().element_sum();
        Track::new(normal.dot(self.origin - base), normal.dot(self.slope), width)
    }
}

// ANCHOR: track
/// What a wide ray does along one direction: where it is at `s` along its longest axis is
/// `origin + s * slope`, give or take `width`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Track {
    /// Where it starts.
    pub origin: f32,
    /// What it gains.
    pub slope: f32,
    /// 1 / slope. Its sign says where the ray is going even if the slope is 0 or -0.
    pub inverse: f32,
    /// Half its width.
    pub width: f32,
}
// ANCHOR_END: track

impl Track {
    #[inline]
    fn new(origin: f32, slope: f32, width: f32) -> Self {
        Self { origin, slope, inverse: 1.0 / slope, width }
    }

    /// Whether its coordinate grows; of a ray that stays where it is either is right.
    #[inline]
    pub fn ascends(&self) -> bool {
        self.inverse > 0.0
    }
}

// ANCHOR: interval
/// A part of a wide ray, both ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Where it begins, along the ray's longest axis.
    pub from: f32,
    /// Where it ends.
    pub to: f32,
}

impl Interval {
    /// The part where the ray, or an edge of it, is at `plane` or below.
    ///
    /// A ray along the plane divides by 0: the crossing is at plus or minus infinity, and all of the
    /// ray is left or nothing. It is NaN when the ray's edge lies in the plane. Then both
    /// comparisons fail, and all is left.
    #[inline]
    pub fn below(self, track: &Track, plane: f32) -> Self {
        let crossing = (plane - track.origin + track.width) * track.inverse;
        if track.ascends() { self.until(crossing) } else { self.since(crossing) }
    }

    /// The part where the ray, or an edge of it, is at `plane` or above.
    #[inline]
    pub fn above(self, track: &Track, plane: f32) -> Self {
        let crossing = (plane - track.origin - track.width) * track.inverse;
        if track.ascends() { self.since(crossing) } else { self.until(crossing) }
    }

    #[inline]
    fn until(self, crossing: f32) -> Self {
        if crossing < self.to { Self { to: crossing, ..self } } else { self }
    }

    #[inline]
    fn since(self, crossing: f32) -> Self {
        if crossing > self.from { Self { from: crossing, ..self } } else { self }
    }
    // ANCHOR_END: interval

    /// What is in both.
    #[inline]
    pub fn and(self, other: Self) -> Self {
        self.since(other.from).until(other.to)
    }

    /// Whether nothing is in it.
    #[inline]
    pub fn is_empty(&self) -> bool {
        !(self.from <= self.to)
    }
}

#[cfg(test)]
mod tests {
    use boxes::aabb::Aabb;
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::{Interval, Track, WideRay};

    const ALL: Interval = Interval { from: 0.0, to: 100.0 };

    /// The chapter's worked number: at 3 and going up by 1/2 for each unit, a quarter wide, a ray is
    /// at 5 or below until it has gone 4.5, and at 5 or above from 3.5 on.
    #[test]
    fn both_sides_of_a_plane_by_hand() {
        let track = Track { origin: 3.0, slope: 0.5, inverse: 2.0, width: 0.25 };
        assert_eq!(ALL.below(&track, 5.0), Interval { from: 0.0, to: 4.5 });
        assert_eq!(ALL.above(&track, 5.0), Interval { from: 3.5, to: 100.0 });
        let down = Track { slope: -0.5, inverse: -2.0, ..track };
        assert_eq!(ALL.below(&down, 1.0), Interval { from: 3.5, to: 100.0 });
        assert_eq!(ALL.above(&down, 1.0), Interval { from: 0.0, to: 4.5 });
    }

    /// AC-06: with either zero, a ray in the plane is on both sides, and one beside it on its own.
    #[test]
    fn along_a_plane_all_is_left_or_nothing() {
        for slope in [0.0_f32, -0.0] {
            for (origin, width, below, above) in [
                (2.0, 0.0, true, true),
                (2.0, 0.5, true, true),
                (2.5, 0.5, true, true),
                (1.0, 0.5, true, false),
                (3.0, 0.5, false, true),
            ] {
                let track = Track { origin, slope, inverse: 1.0 / slope, width };
                let left = |part: Interval| if part.is_empty() { None } else { Some(part) };
                assert_eq!(left(ALL.below(&track, 2.0)), below.then_some(ALL), "{track:?}");
                assert_eq!(left(ALL.above(&track, 2.0)), above.then_some(ALL), "{track:?}");
            }
        }
    }

    /// Wherever the exact ray comes within 8 u of the farthest distance to a side of a plane, that is
    /// in the part for the side: the rest of the width is for the roundings on the way.
    #[test]
    fn no_place_within_the_triangle_tests_error_is_left_out() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(920, trial);
            let mut point = || Vec3::from([0, 1, 2].map(|_| stream.between(-4.0, 5.0)));
            let bounds = Aabb::of_points([point(), point()]);
            let (origin, direction) = (point(), point() * [1.0, 1e-30, 1e25][trial as usize % 3]);
            let far = [0.0, 1e3, 1e6][trial as usize / 3 % 3];
            let ray = Ray { origin: origin + Vec3::splat(far), direction };
            let wide = WideRay::new(&ray, &bounds);
            let axis = trial as usize % 3;
            let plane = bounds.min[axis] + stream.uniform() * bounds.size()[axis];
            let longest = f64::from(direction.abs().max_element());
            let farthest = far + 10.0;
            // Near the crossing, where it matters.
            let slope = f64::from(direction[axis]) / longest;
            let crossing = (f64::from(plane) - f64::from(ray.origin[axis])) / slope;
            let place = crossing + f64::from(farthest) * 1e-6 * (f64::from(stream.uniform()) - 0.5);
            if !(0.0..=f64::from(farthest)).contains(&place) {
                continue;
            }
            let at = f64::from(ray.origin[axis]) + place * slope;
            let margin = f64::from(wide.width) / 4.0;
            let all = Interval { from: 0.0, to: f32::MAX };
            let holds =
                |part: Interval| f64::from(part.from) <= place && place <= f64::from(part.to);
            let track = wide.track(axis);
            if at - margin <= f64::from(plane) {
                assert!(holds(all.below(&track, plane)), "{trial}: {ray:?}");
            }
            if at + margin >= f64::from(plane) {
                assert!(holds(all.above(&track, plane)), "{trial}: {ray:?}");
            }
        }
    }

    #[test]
    fn reach_is_never_short_and_never_infinite() {
        let bounds = Aabb::of_points([Vec3::ZERO, Vec3::ONE]);
        let ray = Ray { origin: Vec3::ZERO, direction: Vec3::new(1.5, -2.5, 0.3) };
        let wide = WideRay::new(&ray, &bounds);
        for t in [0.0, 1e-45, 0.1, 7.0, 1e30] {
            assert!(f64::from(wide.reach(t)) > 2.5 * f64::from(t));
        }
        assert!([f32::MAX, f32::INFINITY, f32::NAN].iter().all(|&t| wide.reach(t) == f32::MAX));
    }
}
