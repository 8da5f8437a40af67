//! The exercises of chapter 11: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p monte-carlo --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 11 has the story of
//! each. Most are judged by the means of many of your answers, so any right way will do.

use glam::{Vec2, Vec3};

/// Exercise 11.1, a point of the disk: uniform over the disk of radius 1 around 0.
///
/// `u` is uniform over the unit square. `common::math` has `sin` and `cos`. See the section "Warps".
pub fn disk(u: Vec2) -> Vec2 {
    let _ = u;
    todo!("exercise 11.1")
}

/// Exercise 11.2, the light of a sky: an estimate of irradiance from one direction.
///
/// The floor's normal is z, and `radiance` says what comes from a direction with z at least 0. Choose
/// a direction by `u`, uniform over the unit square, in any way you like. The mean of your estimates
/// must be the integral of radiance times cosine over the hemisphere. See the section "Choose where
/// to look".
pub fn irradiance(u: Vec2, radiance: fn(Vec3) -> f32) -> f32 {
    let _ = (u, radiance);
    todo!("exercise 11.2")
}

/// Exercise 11.3, a triangle: an estimate of the integral of `value` over its area, from one point.
///
/// `u` is uniform over the unit square. Use uniform points: the check asks for the mean of your
/// estimates and for that of their squares. See the section "Warps".
pub fn over_triangle(corners: [Vec3; 3], u: Vec2, value: fn(Vec3) -> f32) -> f32 {
    let _ = (corners, u, value);
    todo!("exercise 11.3")
}

/// Exercise 11.4, one of many: an estimate of the sum of `values` from one of them.
///
/// Choose each as often as its weight says, with `u` uniform in [0, 1). Weights are at least 0, and
/// one is above. A value whose weight is 0 is 0. The check asks for the mean of your estimates and
/// for that of their squares. See the section "One of many".
pub fn one_of_many(weights: &[f32], values: &[f32], u: f32) -> f32 {
    let _ = (weights, values, u);
    todo!("exercise 11.4")
}

/// Exercise 11.5, find the mistake: the variance of what `samples` were drawn from.
///
/// `naive::variance` is printed in many books. Give the unbiased estimate, right to a part in a
/// million for samples as far from 0 as 10,000. There are two or more of them. See the section "How
/// far off".
pub fn variance(samples: &[f32]) -> f64 {
    let _ = samples;
    todo!("exercise 11.5")
}
