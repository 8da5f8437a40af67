//! RC-09: the poles of a sphere.

use std::f64::consts::PI;

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{Vec2, Vec3};

use super::{CHAPTER, draw};
use crate::longitude::uv;
use crate::naive;

/// RC-09: an arc cosine of almost 1, or of slightly more.
pub(super) const LATITUDE: Case = Case {
    id: "RC-09",
    chapter: CHAPTER,
    input: "texture coordinates within 10^-8 to 10^-1 of a pole",
    most: UNLIMITED,
    naive_fails: |trial| is_wrong(near_pole(trial), naive::sphere_uv),
    robust_fails: |trial| is_wrong(near_pole(trial), uv),
};

fn near_pole(trial: u64) -> Vec3 {
    let mut stream = Stream::of_trial(209, trial);
    let aside = draw::in_cube(&mut stream, 1.0) * draw::decade(&mut stream, -8.0, -1.0);
    let pole = if trial.is_multiple_of(2) { Vec3::Y } else { Vec3::NEG_Y };
    (aside.with_y(0.0) + pole * stream.between(1.0, 3.0)).normalize()
}

/// A millionth of the way from pole to pole is twenty metres on the Earth.
fn is_wrong(normal: Vec3, uv: fn(Vec3) -> Vec2) -> bool {
    let (x, y, z) = (f64::from(normal.x), f64::from(normal.y), f64::from(normal.z));
    // The angle from the nearer pole by its tangent, which near a pole is its own arc to O(θ³).
    let tangent = (x * x + z * z).sqrt() / y.abs();
    let from_pole = arc_tangent(tangent) / PI;
    let latitude = if y > 0.0 { 1.0 - from_pole } else { from_pole };
    let Vec2 { x: u, y: v } = uv(normal);
    let inside = (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v);
    !(inside && (f64::from(v) - latitude).abs() <= 1e-6)
}

/// The series of the arc tangent, for tangents below 0.2.
fn arc_tangent(tangent: f64) -> f64 {
    let square = tangent * tangent;
    let series = (0..12).rev().fold(0.0, |sum, k| 1.0 / f64::from(2 * k + 1) - square * sum);
    tangent * series
}
