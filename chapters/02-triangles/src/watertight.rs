//! The watertight test: a ray can't slip between two triangles that share an edge.
//!
//! After Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (Journal of Computer
//! Graphics Techniques 2(1), 2013). Theirs evaluates the edge functions in `f32`, and again in
//! `f64` when one is 0. Here `f32` only rejects, and every hit is decided and measured in `f64`.

use glam::{Vec2, Vec3};
use ray_casting::ray::Ray;

use crate::area::has_area;
use crate::intersect::{TriangleHit, TriangleTest};

// ANCHOR: ray
/// A ray in whose own coordinates it starts at 0 and runs along the third axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearedRay {
    pub(crate) origin: Vec3,
    pub(crate) longest: Axis,
    pub(crate) shear: Vec2,
    pub(crate) advance: f32,
}

impl TriangleTest for ShearedRay {
    #[inline]
    fn prepare(ray: &Ray) -> Option<Self> {
        let longest = Axis::longest(ray.direction);
        let direction = longest.to_third(ray.direction);
        let usable = direction.z != 0.0 && direction.is_finite() && ray.origin.is_finite();
        let shear = direction.truncate() / direction.z;
        usable.then_some(Self { origin: ray.origin, longest, shear, advance: direction.z })
    }
    // ANCHOR_END: ray

    // ANCHOR: hit
    #[inline]
    fn hit(&self, corners: &[Vec3; 3], t_max: f32) -> Option<TriangleHit> {
        let [a, b, c] = *corners;
        let (a, b, c) = (self.shear(a), self.shear(b), self.shear(c));
        // Nearly every triangle is rejected here. An f32 edge function has the right sign or is 0,
        // so two that differ in sign are proof of a miss.
        if differ_in_sign(edge(b, c), edge(c, a), edge(a, b)) {
            return None;
        }
        self.decide([a, b, c], t_max).filter(|_| has_area(corners))
    }
    // ANCHOR_END: hit
}

/// A triangle that a ray hits, and where; what else there is to know has not been worked out yet, for
/// a nearer one may make it useless.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// How far along the ray, in lengths of its direction: finite and above 0.
    pub t: f32,
    /// The edge functions.
    pub(crate) edges: [f64; 3],
    /// Their sum.
    pub(crate) determinant: f64,
}

impl Measured {
    /// What stands in where there is nothing.
    pub(crate) const NONE: Self = Self { t: f32::INFINITY, edges: [0.0; 3], determinant: 1.0 };

    /// The whole answer.
    #[inline]
    pub fn hit(&self) -> TriangleHit {
        let weights = self.edges.map(|weight| (weight / self.determinant) as f32);
        TriangleHit { t: self.t, barycentric: Vec3::from(weights) }
    }
}

impl ShearedRay {
    // ANCHOR: shear
    /// A corner in the ray's coordinates. It depends on the corner and the ray alone: every
    /// triangle at this corner gets the same bits.
    #[inline]
    pub(crate) fn shear(&self, corner: Vec3) -> Vec3 {
        let offset = self.longest.to_third(corner - self.origin);
        let x = offset.x - self.shear.x * offset.z;
        let y = offset.y - self.shear.y * offset.z;
        Vec3::new(x, y, offset.z)
    }
    // ANCHOR_END: shear

    /// [`measure`] for this ray.
    #[inline]
    pub fn measure(&self, sheared: [Vec3; 3], t_max: f32) -> Option<Measured> {
        measure(self.advance, sheared, t_max)
    }

    /// The same, kept out of the loop over triangles: few come so far.
    #[inline(never)]
    fn decide(&self, sheared: [Vec3; 3], t_max: f32) -> Option<TriangleHit> {
        self.measure(sheared, t_max).map(|measured| measured.hit())
    }
}

// ANCHOR: measure
/// Decides in f64, where the sign of an edge function is exact, and measures what is hit. The
/// corners are in the coordinates of a ray that goes as far as `advance` along the third axis, and
/// the triangle must have an area.
#[inline(always)]
pub(crate) fn measure(advance: f32, sheared: [Vec3; 3], t_max: f32) -> Option<Measured> {
    let [a, b, c] = sheared;
    let (u, v, w) = (exact_edge(b, c), exact_edge(c, a), exact_edge(a, b));
    if differ_in_sign(u, v, w) {
        return None;
    }
    let determinant = sum(u, v, w);
    let depth = sum(u * f64::from(a.z), v * f64::from(b.z), w * f64::from(c.z)) / determinant;
    let t = (depth / f64::from(advance)) as f32;
    // NaN fails every comparison, so 0/0 from a triangle seen edge-on ends here too.
    if !(t > 0.0 && t < t_max) {
        return None;
    }
    Some(Measured { t, edges: [u, v, w], determinant })
}
// ANCHOR_END: measure

// ANCHOR: edge
/// Twice the signed area of the triangle (0, p, q) in the plane across the ray: which side of the
/// edge from p to q the ray passes.
#[inline]
fn edge(p: Vec3, q: Vec3) -> f32 {
    p.x * q.y - p.y * q.x
}

/// The same with a sign that is never wrong: two f32 multiply to 48 bits at most, an f64 holds 53,
/// so both products are exact and their difference is rounded once.
#[inline(always)]
pub(crate) fn exact_edge(p: Vec3, q: Vec3) -> f64 {
    f64::from(p.x) * f64::from(q.y) - f64::from(p.y) * f64::from(q.x)
}
// ANCHOR_END: edge

/// Whether one is negative and one is positive. By the lowest and the highest, which a processor
/// finds without a jump it could guess wrong.
#[inline(always)]
fn differ_in_sign<N: PartialOrd + Default + Copy>(u: N, v: N, w: N) -> bool {
    lower(lower(u, v), w) < N::default() && higher(higher(u, v), w) > N::default()
}

/// The lower of two; either where one is NaN.
#[inline(always)]
fn lower<N: PartialOrd>(x: N, y: N) -> N {
    if x < y { x } else { y }
}

/// The higher of two; either where one is NaN.
#[inline(always)]
fn higher<N: PartialOrd>(x: N, y: N) -> N {
    if x > y { x } else { y }
}

// ANCHOR: sum
/// A sum of three that is the same to the last bit in whatever order they come.
#[inline(always)]
fn sum(x: f64, y: f64, z: f64) -> f64 {
    let (low, high) = if x < y { (x, y) } else { (y, x) };
    let (low, middle) = if z < low { (z, low) } else { (low, z) };
    let (middle, high) = if high < middle { (high, middle) } else { (middle, high) };
    (low + high) + middle
}
// ANCHOR_END: sum

/// One of the three coordinate axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// The axis along which `direction` goes farthest.
    #[inline]
    fn longest(direction: Vec3) -> Self {
        let size = direction.abs();
        match size {
            _ if size.x > size.y && size.x > size.z => Self::X,
            _ if size.y > size.z => Self::Y,
            _ => Self::Z,
        }
    }

    /// The coordinates' places when this one comes last; turned, not mirrored.
    #[inline]
    pub(crate) fn order(self) -> [usize; 3] {
        match self {
            Self::X => [1, 2, 0],
            Self::Y => [2, 0, 1],
            Self::Z => [0, 1, 2],
        }
    }

    /// The same vector with this coordinate last.
    #[inline]
    fn to_third(self, vector: Vec3) -> Vec3 {
        let Vec3 { x, y, z } = vector;
        match self {
            Self::X => Vec3::new(y, z, x),
            Self::Y => Vec3::new(z, x, y),
            Self::Z => vector,
        }
    }
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::{Axis, ShearedRay, differ_in_sign, edge, exact_edge, sum};
    use crate::hard::shapes::{ask, inner_weights, mix, point, towards, triangle};
    use crate::intersect::TriangleTest;
    use crate::reference::DoubleRay;
    use crate::surface::between;

    /// The chapter's worked number: from (1, 1, 5) straight down on a triangle in the plane z = 1.
    #[test]
    fn a_hit_by_hand() {
        let corners =
            [Vec3::new(0.0, 0.0, 1.0), Vec3::new(4.0, 0.0, 1.0), Vec3::new(0.0, 6.0, 1.0)];
        let ray = Ray { origin: Vec3::new(1.0, 1.0, 5.0), direction: Vec3::new(0.0, 0.0, -2.0) };
        let hit = ask::<ShearedRay>(&ray, &corners, f32::INFINITY).expect("it is inside");
        // Edge functions 14, 6 and 4 of 24 in all; four units down at two a step.
        assert_eq!(hit.t, 2.0);
        assert_eq!(hit.barycentric, Vec3::new(14.0, 6.0, 4.0) / 24.0);
        assert_eq!(ask::<ShearedRay>(&ray, &corners, 2.0), None);
        let behind = Ray { direction: -ray.direction, ..ray };
        assert_eq!(ask::<ShearedRay>(&behind, &corners, f32::INFINITY), None);
    }

    /// TR-11: whatever the triangle, the weights sum to 1 within 4 u, and t agrees with f64.
    #[test]
    fn hits_agree_with_the_reference() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(1, trial);
            let corners = triangle(&mut stream);
            let target = mix(&corners, inner_weights(&mut stream));
            let ray = towards(point(&mut stream), target).expect("two random points");
            let Some(hit) = ask::<ShearedRay>(&ray, &corners, f32::INFINITY) else { continue };
            let Some(exact) = ask::<DoubleRay>(&ray, &corners, f32::INFINITY) else { continue };
            assert!((hit.barycentric.element_sum() - 1.0).abs() <= 2.0 * f32::EPSILON);
            // The error grows as the triangle is seen more edge-on.
            let [a, b, c] = corners;
            let cosine = (b - a).cross(c - a).normalize().dot(ray.direction).abs();
            let allowed = 8.0 * f32::EPSILON * (hit.t + ray.origin.length()) / cosine;
            assert!((hit.t - exact.t).abs() <= allowed, "{trial}: {} {}", hit.t, exact.t);
            let gap = (between(corners, hit.barycentric) - ray.at(hit.t)).length();
            assert!(gap <= allowed, "{trial}: {gap}");
        }
    }

    /// The quick rejection never rejects what f64 would accept: rounding doesn't swap two products.
    #[test]
    fn an_f32_edge_function_has_the_right_sign_or_is_zero() {
        for trial in 0..300_000 {
            let mut stream = Stream::of_trial(2, trial);
            let p = point(&mut stream);
            let nearly_in_line = p * stream.between(-3.0, 3.0);
            let scale = [1.0, 1e-20, 1e18][(trial % 3) as usize];
            let (p, q) = (scale * p, scale * nearly_in_line);
            let (quick, exact) = (edge(p, q), exact_edge(p, q));
            assert!(quick == 0.0 || f64::from(quick.signum()) == exact.signum(), "{trial}");
            assert_eq!(exact_edge(q, p), -exact);
        }
        assert!(differ_in_sign(1.0, 0.0, -1e-30) && !differ_in_sign(0.0, 0.0, -1.0));
        assert!(!differ_in_sign(f32::NAN, 1.0, 0.0) && !differ_in_sign(1.0, f32::NAN, 3.0));
    }

    #[test]
    fn the_sum_is_the_same_in_any_order() {
        for trial in 0..10_000 {
            let mut stream = Stream::of_trial(4, trial);
            let [x, y, z] = point(&mut stream).as_dvec3().to_array().map(|it| it * it * it);
            let all = [sum(x, y, z), sum(y, z, x), sum(z, x, y), sum(z, y, x), sum(y, x, z)];
            assert!(all.iter().all(|it| it.to_bits() == sum(x, z, y).to_bits()));
            assert_eq!(sum(-x, -y, -z), -sum(x, y, z));
        }
    }

    #[test]
    fn the_longest_axis_comes_third_and_nothing_is_mirrored() {
        for (axis, direction) in [
            (Axis::X, Vec3::new(-3.0, 1.0, 2.0)),
            (Axis::Y, Vec3::new(1.0, 3.0, -2.0)),
            (Axis::Z, Vec3::new(1.0, 2.0, -3.0)),
        ] {
            assert_eq!(Axis::longest(direction), axis);
            assert_eq!(axis.to_third(direction).z.abs(), 3.0);
            let turned = [Vec3::X, Vec3::Y, Vec3::Z].map(|it| axis.to_third(it));
            assert_eq!(turned[0].cross(turned[1]), turned[2]);
            assert_eq!(Vec3::from(axis.order().map(|at| direction[at])), axis.to_third(direction));
        }
        assert!(ShearedRay::prepare(&Ray { origin: Vec3::ZERO, direction: Vec3::ZERO }).is_none());
    }

    /// TR-07 in a slanted plane, where rounding may tip the triangle: then a hit lies between its
    /// corners, and it is never NaN.
    #[test]
    fn a_ray_in_a_slanted_plane_misses_or_hits_between_the_corners() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(5, trial);
            let [a, u, v] = triangle(&mut stream).map(|it| (1000.0 * it).round());
            let corners = [a, a + u, a + v];
            let ray = Ray { origin: a - 3.0 * u + v, direction: 7.0 * u - 2.0 * v };
            let Some(hit) = ask::<ShearedRay>(&ray, &corners, f32::INFINITY) else { continue };
            let third = |it: Vec3| Axis::longest(ray.direction).to_third(it).z;
            let depths = corners.map(|it| third(it - ray.origin) / third(ray.direction));
            let [low, high] = [
                depths.iter().copied().fold(f32::MAX, f32::min),
                depths.iter().copied().fold(f32::MIN, f32::max),
            ];
            assert!(hit.barycentric.is_finite() && hit.t >= 0.999_999 * low);
            assert!(hit.t <= 1.000_001 * high);
        }
    }
}
