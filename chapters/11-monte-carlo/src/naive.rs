//! The textbook's formulas: right on paper.

use common::math::acos;
use glam::{Vec2, Vec3};

use crate::warp::disk;

// ANCHOR: unit
/// 32 random bits as a number from 0 to below 1.
pub fn unit(bits: u32) -> f32 {
    bits as f32 * 2.328_306_4e-10
}
// ANCHOR_END: unit

// ANCHOR: cosine
/// A point of the disk, raised to the hemisphere.
pub fn cosine(u: Vec2) -> Vec3 {
    let point = disk::concentric(u);
    point.extend((1.0 - point.x * point.x - point.y * point.y).sqrt())
}

/// The same with the cure that everybody finds first.
pub fn clamped_cosine(u: Vec2) -> Vec3 {
    let point = disk::concentric(u);
    point.extend((1.0 - point.x * point.x - point.y * point.y).max(0.0).sqrt())
}
// ANCHOR_END: cosine

// ANCHOR: variance
/// The mean of the squares less the square of the mean.
pub fn variance(samples: &[f32]) -> f32 {
    let count = samples.len() as f32;
    let sum: f32 = samples.iter().sum();
    let squares: f32 = samples.iter().map(|sample| sample * sample).sum();
    squares / count - (sum / count) * (sum / count)
}
// ANCHOR_END: variance

// ANCHOR: mean
/// The mean of `count` times the same number, added up one by one.
pub fn mean_of_equal(number: f32, count: u32) -> f32 {
    let mut sum = 0.0;
    for _ in 0..count {
        sum += number;
    }
    sum / count as f32
}
// ANCHOR_END: mean

// ANCHOR: angle
/// The angle between two directions of length 1.
pub fn angle(one: Vec3, other: Vec3) -> f32 {
    acos(one.dot(other))
}
// ANCHOR_END: angle

// ANCHOR: pick
/// Which of several things a number u picks: the first up to which the weights add up to u.
pub fn pick(weights: &[f32], u: f32) -> usize {
    let total: f32 = weights.iter().sum();
    let mut sum = 0.0;
    for (index, weight) in weights.iter().enumerate() {
        sum += weight / total;
        if u <= sum {
            return index;
        }
    }
    weights.len()
}
// ANCHOR_END: pick

// ANCHOR: strata
/// The point at the part `u` of stratum number `index` of `count`.
pub fn place(index: u32, count: u32, u: f32) -> f32 {
    (index as f32 + u) / count as f32
}
// ANCHOR_END: strata

// ANCHOR: frame
/// Two directions at right angles to `normal` and each other.
///
/// Frisvad, "Building an orthonormal basis from a 3D unit vector without normalization" (Journal of
/// Graphics Tools 16(3), 2012), listing 3.
pub fn frame(normal: Vec3) -> [Vec3; 2] {
    if normal.z < -0.999_999_9 {
        return [Vec3::NEG_Y, Vec3::NEG_X];
    }
    let a = 1.0 / (1.0 + normal.z);
    let b = -normal.x * normal.y * a;
    [
        Vec3::new(1.0 - normal.x * normal.x * a, b, -normal.x),
        Vec3::new(b, 1.0 - normal.y * normal.y * a, -normal.y),
    ]
}
// ANCHOR_END: frame

// ANCHOR: cap
/// The solid angle of a ball of radius 1 seen from a `distance` of its centre.
pub fn solid_angle(distance: f32) -> f32 {
    let sine = 1.0 / distance;
    std::f32::consts::TAU * (1.0 - (1.0 - sine * sine).sqrt())
}

/// A direction towards it, by a uniform cosine.
pub fn towards_ball(distance: f32, u: Vec2) -> Vec3 {
    let sine = 1.0 / distance;
    let lowest = (1.0 - sine * sine).sqrt();
    let z = 1.0 - u.x * (1.0 - lowest);
    let radius = (1.0 - z * z).max(0.0).sqrt();
    (radius * disk::direction(std::f32::consts::TAU * u.y)).extend(z)
}
// ANCHOR_END: cap
