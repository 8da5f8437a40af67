//! What the hard cases draw their inputs from.

use common::math;
use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::aabb::Aabb;
use crate::oracle::{Verdict, verdict};
use crate::slab::{BoxRay, PAD};

/// A point of the lopsided box 2 by 4 by 6 around the origin, times `scale`.
pub(super) fn point(stream: &mut Stream, scale: f32) -> Vec3 {
    let x = stream.between(-1.0, 1.0);
    let y = stream.between(-2.0, 2.0);
    scale * Vec3::new(x, y, stream.between(-3.0, 3.0))
}

/// A number from 0 to below `count`.
pub(super) fn below(stream: &mut Stream, count: usize) -> usize {
    stream.bits() as usize % count
}

/// 1 or -1.
pub(super) fn sign(stream: &mut Stream) -> f32 {
    if stream.bits() & 1 == 0 { 1.0 } else { -1.0 }
}

/// 10 to a power between `low` and `high`.
pub(super) fn decade(stream: &mut Stream, low: f32, high: f32) -> f32 {
    math::pow(10.0, stream.between(low, high))
}

/// Two to the power `exponent`, from -126 to 127.
pub(super) fn power_of_two(exponent: i32) -> f32 {
    f32::from_bits(((127 + exponent) as u32) << 23)
}

/// A point in the box: each coordinate one of the faces', or anywhere between them.
pub(super) fn point_in(stream: &mut Stream, bounds: &Aabb) -> Vec3 {
    let mut coordinate = |low: f32, high: f32| match stream.bits() % 4 {
        0 => low,
        1 => high,
        _ => (low + (high - low) * stream.uniform()).clamp(low, high),
    };
    let Aabb { min, max } = *bounds;
    let x = coordinate(min.x, max.x);
    let y = coordinate(min.y, max.y);
    Vec3::new(x, y, coordinate(min.z, max.z))
}

/// Whether the careful test is wrong: it misses what `f64` says is met, or meets what is clear of
/// the ray by more than twice the pad and the spacing of the coordinates.
pub(super) fn is_wrong(ray: &Ray, bounds: &Aabb) -> bool {
    let met = BoxRay::new(ray, bounds).enter(bounds, f32::INFINITY).is_some();
    match allowed(ray, bounds) {
        Verdict::Met => !met,
        Verdict::Missed => met,
        Verdict::Close => false,
    }
}

/// What `f64` says, with a margin that the careful test may use up.
pub(crate) fn allowed(ray: &Ray, bounds: &Aabb) -> Verdict {
    let largest = |vector: Vec3| f64::from(vector.abs().max_element());
    let corners = largest(bounds.min).max(largest(bounds.max));
    let reach = corners + largest(ray.origin);
    verdict(ray, bounds, f64::INFINITY, 2.0 * f64::from(PAD) * reach)
}
