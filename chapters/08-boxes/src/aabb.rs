//! Axis-aligned boxes: what two corners say of a thing's place.

use glam::Vec3;

// ANCHOR: aabb
/// A box whose sides lie along the axes.
///
/// It is empty when `min` is above `max` on some axis. What this module makes holds no NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the least coordinates.
    pub min: Vec3,
    /// The corner with the greatest.
    pub max: Vec3,
}
// ANCHOR_END: aabb

impl Aabb {
    // ANCHOR: union
    /// The box of nothing: the union of it and another is the other.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// The smallest box around both.
    ///
    /// By `f32::min`, which takes the other number where one is NaN. `Vec3::min` gives NaN back when
    /// it comes second, and one bad vertex would then blind a whole scene (hard cases X-01, BX-07).
    #[inline]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: by_axis(self.min, other.min, f32::min),
            max: by_axis(self.max, other.max, f32::max),
        }
    }
    // ANCHOR_END: union

    /// The smallest box around this one and `point`; this one when the point isn't finite.
    #[inline]
    pub fn grow(self, point: Vec3) -> Self {
        if point.is_finite() { self.union(Self { min: point, max: point }) } else { self }
    }

    /// The smallest box around all the finite ones among `points`.
    pub fn of_points(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::grow)
    }

    /// The same with its faces moved outward by `margin`, each component of which is at least 0, and
    /// by one float more, for the rounding of the sum. An empty box stays empty.
    pub fn widened(self, margin: Vec3) -> Self {
        if self.is_empty() {
            return Self::EMPTY;
        }
        Self {
            min: Vec3::from((self.min - margin).to_array().map(f32::next_down)),
            max: Vec3::from((self.max + margin).to_array().map(f32::next_up)),
        }
    }

    /// Whether there is no point in it; NaN makes it so, too.
    #[inline]
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Whether `point` is inside or on a face.
    pub fn contains(&self, point: Vec3) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }

    /// Its sides' lengths; 0 for an empty box.
    #[inline]
    pub fn size(&self) -> Vec3 {
        if self.is_empty() { Vec3::ZERO } else { self.max - self.min }
    }

    /// Its middle; NaN for an empty box. Halved before the sum, which could overflow.
    #[inline]
    pub fn center(&self) -> Vec3 {
        0.5 * self.min + 0.5 * self.max
    }

    // ANCHOR: surface_area
    /// The area of its six faces; 0 for an empty box.
    #[inline]
    pub fn surface_area(&self) -> f32 {
        let Vec3 { x, y, z } = self.size();
        2.0 * (x * y + y * z + z * x)
    }
    // ANCHOR_END: surface_area

    /// The axis of its longest side: 0, 1 or 2 for x, y or z; the first of two that are as long.
    pub fn longest_axis(&self) -> usize {
        let Vec3 { x, y, z } = self.size();
        match () {
            () if x >= y && x >= z => 0,
            () if y >= z => 1,
            () => 2,
        }
    }
}

/// The vector of what `choose` makes of both components on each axis.
#[inline]
fn by_axis(a: Vec3, b: Vec3, choose: fn(f32, f32) -> f32) -> Vec3 {
    Vec3::new(choose(a.x, b.x), choose(a.y, b.y), choose(a.z, b.z))
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;

    use super::Aabb;

    /// One wide, two high, three deep, and nowhere near the origin.
    const LOPSIDED: Aabb =
        Aabb { min: Vec3::new(4.0, -7.0, 10.0), max: Vec3::new(5.0, -5.0, 13.0) };

    #[test]
    fn a_box_by_hand() {
        assert_eq!(LOPSIDED.size(), Vec3::new(1.0, 2.0, 3.0));
        assert_eq!(LOPSIDED.surface_area(), 22.0, "2 (1*2 + 2*3 + 3*1)");
        assert_eq!(LOPSIDED.center(), Vec3::new(4.5, -6.0, 11.5));
        assert_eq!(LOPSIDED.longest_axis(), 2);
    }

    #[test]
    fn the_longest_axis_of_every_order() {
        for (size, axis) in [
            ([3.0, 2.0, 1.0], 0),
            ([2.0, 3.0, 1.0], 1),
            ([1.0, 2.0, 3.0], 2),
            ([1.0, 2.0, 2.0], 1),
            ([2.0, 1.0, 2.0], 0),
            ([0.0, 0.0, 0.0], 0),
        ] {
            let corner = Vec3::new(-8.0, 2.0, 5.0);
            let aabb = Aabb { min: corner, max: corner + Vec3::from(size) };
            assert_eq!(aabb.longest_axis(), axis, "{size:?}");
        }
    }

    #[test]
    fn a_union_is_the_smallest_box_around_both() {
        for trial in 0..50_000 {
            let mut stream = Stream::of_trial(801, trial);
            let mut point = || {
                let mut component = || stream.between(-9.0, 9.0);
                Vec3::new(component(), component(), component())
            };
            let points = [point(), point(), point(), point()];
            let [first, second] =
                [&points[..2], &points[2..]].map(|part| Aabb::of_points(part.iter().copied()));
            let whole = first.union(second);
            assert_eq!(whole, second.union(first));
            assert_eq!(whole, Aabb::of_points(points));
            assert!(points.iter().all(|&point| whole.contains(point)));
            for axis in 0..3 {
                assert!(points.iter().any(|point| point[axis] == whole.min[axis]));
                assert!(points.iter().any(|point| point[axis] == whole.max[axis]));
            }
        }
    }

    #[test]
    fn nothing_is_empty_and_adds_nothing() {
        assert!(Aabb::EMPTY.is_empty() && !LOPSIDED.is_empty());
        assert_eq!(Aabb::EMPTY.union(LOPSIDED), LOPSIDED);
        assert_eq!(LOPSIDED.union(Aabb::EMPTY), LOPSIDED);
        assert_eq!((Aabb::EMPTY.surface_area(), Aabb::EMPTY.size()), (0.0, Vec3::ZERO));
        assert_eq!(Aabb::EMPTY.widened(Vec3::ONE), Aabb::EMPTY);
        assert!(!Aabb::EMPTY.contains(Vec3::ZERO));
    }

    /// Hard case BX-07: NaN in either, in whichever coordinate, poisons nothing.
    #[test]
    fn nan_and_infinity_do_not_spread() {
        let nan = Aabb { min: Vec3::NAN, max: Vec3::NAN };
        assert!(nan.is_empty());
        assert_eq!((nan.union(LOPSIDED), LOPSIDED.union(nan)), (LOPSIDED, LOPSIDED));
        let bad = [Vec3::NAN, Vec3::ZERO.with_y(f32::NAN), Vec3::ONE.with_z(f32::INFINITY)];
        for point in bad {
            assert_eq!(LOPSIDED.grow(point), LOPSIDED);
            assert!(!LOPSIDED.contains(point));
        }
        assert_eq!(Aabb::of_points(bad), Aabb::EMPTY);
    }

    #[test]
    fn flat_boxes_are_not_empty() {
        let flat = Aabb { max: LOPSIDED.max.with_y(-7.0), ..LOPSIDED };
        assert!(!flat.is_empty() && flat.contains(Vec3::new(4.5, -7.0, 12.0)));
        assert_eq!(flat.surface_area(), 6.0);
    }

    #[test]
    fn a_widened_box_holds_the_margin_whatever_the_rounding() {
        for trial in 0..50_000 {
            let mut stream = Stream::of_trial(802, trial);
            let at = Vec3::splat(stream.between(-1e4, 1e4));
            let margin = stream.uniform() * 1e-3;
            let wide = Aabb { min: at, max: at }.widened(Vec3::splat(margin));
            let (at, margin) = (f64::from(at.x), f64::from(margin));
            assert!(f64::from(wide.min.x) <= at - margin && at + margin <= f64::from(wide.max.x));
            assert!(f64::from(wide.max.x - wide.min.x) < 2.0 * margin + 5e-3);
        }
    }

    #[test]
    fn the_middle_of_the_largest_box_is_finite() {
        let huge = Aabb { min: Vec3::splat(2e38), max: Vec3::splat(3e38) };
        assert!((huge.center() / 2.5e38 - Vec3::ONE).length() < 1e-6);
    }
}
