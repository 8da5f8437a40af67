//! The exercises of chapter 13: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p light-sampling --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 13 has the story of
//! each.

use common::film::Color;
use glam::{Vec2, Vec3};

/// Exercise 13.1, from area to solid angle: the density, per steradian, of the direction to a point
/// that was chosen uniformly over a lamp.
///
/// `distance` is the point's, `cosine` that of the angle at the lamp, from 0 to 1, and `area` the
/// lamp's. See the section "From directions to points".
pub fn density(distance: f32, cosine: f32, area: f32) -> f32 {
    let _ = (distance, cosine, area);
    todo!("exercise 13.1")
}

/// Exercise 13.2, a whole estimator: an estimate of the radiance that a matte surface sends on of the
/// light of a triangular lamp.
///
/// The surface is at the origin, with this `normal` and `albedo`. The lamp has these `corners`,
/// counter-clockwise on the side that sends out the `radiance`; its other side is dark. `u` are two
/// random numbers in [0, 1). Nothing is in between. The mean of your estimates must be what all of the
/// lamp sends. The check takes many. You may use your `density`. See the section "A point of the
/// lamp".
pub fn direct(normal: Vec3, albedo: f32, corners: [Vec3; 3], radiance: f32, u: Vec2) -> f32 {
    let _ = (normal, albedo, corners, radiance, u);
    todo!("exercise 13.2")
}

/// Exercise 13.3, a ball's cap: the density, per steradian, of directions that are uniform over a ball
/// of this `radius` whose centre is at this `distance`, which is larger.
///
/// Distances go up to a million radii. See the section "A ball's cap".
pub fn ball_density(distance: f32, radius: f32) -> f32 {
    let _ = (distance, radius);
    todo!("exercise 13.3")
}

/// Exercise 13.4, one of many: an estimate of the light of all lamps together, from one of them.
///
/// `powers` are the lamps' powers, `lights` what each would bring; look at one only, and choose it as
/// often as its power says. `chance` is a random number, uniform in [0, 1). A lamp without power
/// brings nothing. The check takes many. See the section "One of many lamps".
pub fn one_lamp(powers: &[f32], lights: &[f32], chance: f32) -> f32 {
    let _ = (powers, lights, chance);
    todo!("exercise 13.4")
}

/// Exercise 13.5, once and not twice: the part of a lamp's light that counts, 0 or 1, where a path
/// came upon the lamp by itself.
///
/// `from_eye` says that it is the first thing the path met. `from_mirror` says that the surface before
/// was a mirror or glass. `is_chosen` says that the lamp is one that is looked at, which lamps with too
/// little power are not. See the section "Once, and not twice".
pub fn share(from_eye: bool, from_mirror: bool, is_chosen: bool) -> f32 {
    let _ = (from_eye, from_mirror, is_chosen);
    todo!("exercise 13.5")
}

/// Exercise 13.6, find the mistake: the light of a point of a lamp.
///
/// `naive::published` is the report's line. Give what it should: an estimate of the light that leaves
/// the surface. `brdf` is the surface's, `cosine` the one at the surface and `lamp_cosine` the one at
/// the lamp, below 0 where the lamp's dark side is seen. `density` is that with which the point was
/// chosen, per unit of area. See the section "From directions to points".
pub fn light(
    radiance: Color,
    brdf: Color,
    cosine: f32,
    lamp_cosine: f32,
    distance: f32,
    density: f32,
) -> Color {
    let _ = (radiance, brdf, cosine, lamp_cosine, distance, density);
    todo!("exercise 13.6")
}
