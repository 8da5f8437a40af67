//! BP-01: an eye and a lamp on opposite sides.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::draw::{direction, neighbour};
use super::{CHAPTER, U};
use crate::models::half_vector;
use crate::naive;

/// BP-01: the half vector of two opposite directions, or of two that are so but for their last bit.
pub(super) const HALF: Case = Case {
    id: "BP-01",
    chapter: CHAPTER,
    input: "the lamp straight behind the point, to the last bit or so",
    most: UNLIMITED,
    naive_fails: |trial| is_wrong(opposite(trial), naive::half_vector),
    robust_fails: |trial| is_wrong(opposite(trial), half_vector),
};

/// The directions to the eye and to the lamp.
fn opposite(trial: u64) -> [Vec3; 2] {
    let mut stream = Stream::of_trial(401, trial);
    let toward_eye = direction(&mut stream);
    let mut step = |component: f32| neighbour(-component, (stream.bits() % 3) as i32 - 1);
    [toward_eye, Vec3::new(step(toward_eye.x), step(toward_eye.y), step(toward_eye.z))]
}

/// The half vector is finite, the same with eye and lamp exchanged to the bit, and where the sum of
/// the two has a direction it is that one.
///
/// Numbers that close are added without rounding, so nothing but the division by the length is
/// rounded: five roundings, and one more for each of the two products in the square of the length.
fn is_wrong([eye, light]: [Vec3; 2], half: fn(Vec3, Vec3) -> Vec3) -> bool {
    let found = half(eye, light);
    let exact = (eye.as_dvec3() + light.as_dvec3()).normalize_or_zero();
    let exchanged = half(light, eye).to_array().map(f32::to_bits);
    !((found.as_dvec3() - exact).length() <= 8.0 * U)
        || found.to_array().map(f32::to_bits) != exchanged
}
