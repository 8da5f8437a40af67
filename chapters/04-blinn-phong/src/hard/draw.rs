//! What the hard cases draw their inputs from.

use common::math;
use common::sampler::Stream;
use glam::Vec3;

/// A direction of length 1; not quite uniform, which no case needs.
pub(super) fn direction(stream: &mut Stream) -> Vec3 {
    let mut component = || stream.between(-1.0, 1.0);
    let vector = Vec3::new(component(), component(), component());
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
}

/// 10 to a power between `low` and `high`.
pub(super) fn decade(stream: &mut Stream, low: f32, high: f32) -> f32 {
    math::pow(10.0, stream.between(low, high))
}

/// A number that is `steps` steps of `f32` away from `number`, which is not 0.
pub(super) fn neighbour(number: f32, steps: i32) -> f32 {
    f32::from_bits(number.to_bits().wrapping_add_signed(steps))
}
