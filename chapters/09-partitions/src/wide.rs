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
/// 8 u for the triangle test: 6 for a corner in the ray's coordinates, 2 for `t` and its product
/// with the direction. 6 u for where the ray crosses a plane: two differences, a quotient, its
/// inverse, a product. 12 u for the planes of a grid, whose places are rounded, and where
/// [`crate::cells::Side::index`] rounds otherwise. That makes 26; a tree takes less.
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
