//! Directions of the upper hemisphere, z at least 0.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3};

use super::disk;

/// The density of uniform directions, per steradian: the hemisphere has 2π of them.
pub const UNIFORM: f32 = 1.0 / TAU;

// ANCHOR: uniform
/// Uniform directions: the height z is uniform (Archimedes), and so is the angle around it.
#[inline]
pub fn uniform(u: Vec2) -> Vec3 {
    let z = u.x;
    let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    (radius * disk::direction(TAU * u.y)).extend(z)
}
// ANCHOR_END: uniform

// ANCHOR: cosine
/// Directions as dense as the cosine of their angle to z: points of the disk, raised to the
/// hemisphere (Malley's method).
#[inline]
pub fn cosine(u: Vec2) -> Vec3 {
    raised(disk::concentric(u))
}

/// A point of the disk, raised to the hemisphere.
#[inline]
pub fn raised(point: Vec2) -> Vec3 {
    // Rounding can carry a point of the rim past it (hard case MC-02), and a height of 0 would have
    // the density 0 (MC-03).
    let z = (1.0 - point.length_squared()).max(LOWEST * LOWEST).sqrt();
    point.extend(z)
}

/// The density of [`cosine`], per steradian, of a direction whose height is `z`.
#[inline]
pub fn cosine_density(z: f32) -> f32 {
    z.max(0.0) / PI
}

/// A point of the rim is known to about 2⁻²⁴, its height therefore to 2⁻¹² at best.
const LOWEST: f32 = 1.0 / 4096.0;
// ANCHOR_END: cosine
