//! Uniform directions.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3};

use super::disk;

/// The density, per steradian: the sphere has 4π of them.
pub const DENSITY: f32 = 1.0 / (4.0 * PI);

// ANCHOR: sphere
/// Uniform directions: the height is uniform, and so is the angle around it.
#[inline]
pub fn uniform(u: Vec2) -> Vec3 {
    let z = 1.0 - 2.0 * u.x;
    // 1 - z² without taking a difference of squares.
    let radius = 2.0 * (u.x * (1.0 - u.x)).sqrt();
    (radius * disk::direction(TAU * u.y)).extend(z)
}
// ANCHOR_END: sphere
