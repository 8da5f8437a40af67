//! What the hard cases draw their inputs from.

use common::sampler::Stream;
use glam::{DVec3, Vec3};

/// A vector in the cube from -`side` to `side`.
pub(super) fn in_cube(stream: &mut Stream, side: f32) -> Vec3 {
    let x = stream.between(-side, side);
    let y = stream.between(-side, side);
    let z = stream.between(-side, side);
    Vec3::new(x, y, z)
}

/// A direction of length 1, to `f64`; not quite uniform, which no case needs.
pub(super) fn direction(stream: &mut Stream) -> DVec3 {
    let vector = in_cube(stream, 1.0).as_dvec3();
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
}

/// A direction at right angles to another, both of length 1.
pub(super) fn across(stream: &mut Stream, axis: DVec3) -> DVec3 {
    let other = direction(stream);
    let across = other - other.dot(axis) * axis;
    if across.length() > 0.1 { across.normalize() } else { self::across(stream, axis) }
}

/// 10 to a power between `low` and `high`.
pub(super) fn decade(stream: &mut Stream, low: f32, high: f32) -> f32 {
    common::math::pow(10.0, stream.between(low, high))
}

/// A whole number from `low` to `high`.
pub(super) fn whole(stream: &mut Stream, low: i32, high: i32) -> i32 {
    let count = (high - low + 1) as u32;
    low + (stream.bits() % count) as i32
}
