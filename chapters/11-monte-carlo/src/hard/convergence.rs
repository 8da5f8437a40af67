//! MC-10: does an error fall as it must?

use common::hard::Case;
use glam::Vec2;

use super::CHAPTER;
use crate::convergence::{error, slope};
use crate::estimator::Sample;
use crate::points::Points;
use crate::sky;
use crate::warp::hemisphere;

/// MC-10: the naive estimator samples by one density and divides by another, which is said to
/// converge all the same.
pub(super) const SLOPE: Case = Case {
    id: "MC-10",
    chapter: CHAPTER,
    input: "how fast the error of a sky's light falls, from 64 samples to 4096",
    most: 4,
    naive_fails: |trial| is_not_half(trial, mismatched),
    robust_fails: |trial| is_not_half(trial, sky::cosine),
};

// ANCHOR: mismatched
/// Directions as dense as their cosine, divided by the density of uniform ones.
pub(super) fn mismatched(u: Vec2) -> Sample {
    let direction = hemisphere::cosine(u);
    let value = sky::radiance(direction) * direction.z;
    Sample { value: f64::from(value), density: f64::from(hemisphere::UNIFORM) }
}
// ANCHOR_END: mismatched

/// Over 400 seeds an error is known to 1/√800 of itself, so the slope to 0.012.
fn is_not_half(trial: u64, strategy: fn(Vec2) -> Sample) -> bool {
    let counts = [64, 4096];
    let exact = sky::IRRADIANCE;
    // Seeds begin anew for each trial: 64 and 4096 samples share their first.
    let turned = |u: Vec2| strategy(Vec2::new(u.x, (u.y + trial as f32 / 4.0).fract()));
    let errors = counts.map(|count| error(Points::Random, count, 400, exact, turned));
    !((slope(counts, errors) + 0.5).abs() <= 0.05)
}
