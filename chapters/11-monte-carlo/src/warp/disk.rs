//! Uniform points of the unit disk.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use common::math::sin_cos;
use glam::Vec2;

/// The density per area: one over the disk's area.
pub const DENSITY: f32 = 1.0 / PI;

// ANCHOR: polar
/// By radius and angle: a ring of radius r has a length in proportion to r, so r is a square root.
#[inline]
pub fn polar(u: Vec2) -> Vec2 {
    u.x.sqrt() * direction(TAU * u.y)
}

/// The unit vector at `angle`, in radians.
#[inline]
pub fn direction(angle: f32) -> Vec2 {
    let (sine, cosine) = sin_cos(angle);
    Vec2::new(cosine, sine)
}
// ANCHOR_END: polar

// ANCHOR: concentric
/// The same, such that squares around the middle become circles: neighbours stay neighbours, and
/// points that were spread evenly stay so.
///
/// Shirley and Chiu, "A low distortion map between disk and square" (Journal of Graphics Tools 2(3),
/// 1997).
#[inline]
pub fn concentric(u: Vec2) -> Vec2 {
    let (radius, angle) = radius_and_angle(u);
    radius * direction(angle)
}

/// The radius of that point, which may be below 0, and its angle.
#[inline]
pub fn radius_and_angle(u: Vec2) -> (f32, f32) {
    let Vec2 { x, y } = 2.0 * u - Vec2::ONE;
    if x.abs() > y.abs() {
        (x, FRAC_PI_4 * (y / x))
    } else {
        let angle = FRAC_PI_2 - FRAC_PI_4 * (x / y);
        // In the middle 0 / 0 is no angle, and any will do.
        (y, if y == 0.0 { 0.0 } else { angle })
    }
}
// ANCHOR_END: concentric
