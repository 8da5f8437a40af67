//! The exercises of chapter 7: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p fresnel --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 7 has the story of
//! each.

use common::film::Color;
use glam::Vec3;

/// Exercise 7.1, Snell's law: the cosine beyond an interface, or None where all is reflected.
///
/// The ray comes from a medium of index `near` upon one of index `far`; `cosine` is that of the
/// angle on its own side, from 0 to 1. See the section "Bending light".
pub fn far_cosine(near: f32, far: f32, cosine: f32) -> Option<f32> {
    let _ = (near, far, cosine);
    todo!("exercise 7.1")
}

/// Exercise 7.2, in and out: the direction in which light goes on through the surface of a body, or
/// None where all is reflected.
///
/// `incoming` has length 1. `outward` has too, and points out of the body, whichever side the ray
/// comes from. The body has the index `index`, and around it is air, of index 1. See the section
/// "Bending light".
pub fn refract(incoming: Vec3, outward: Vec3, index: f32) -> Option<Vec3> {
    let _ = (incoming, outward, index);
    todo!("exercise 7.2")
}

/// Exercise 7.3, Fresnel's equations: the part of unpolarized light that is reflected.
///
/// As in exercise 7.1; the indices are never equal. See the section "How much is reflected".
pub fn reflectance(near: f32, far: f32, cosine: f32) -> f32 {
    let _ = (near, far, cosine);
    todo!("exercise 7.3")
}

/// Exercise 7.4, Schlick's approximation, into the denser medium and out of it.
///
/// As in exercise 7.3. See the section "Schlick's approximation".
pub fn schlick(near: f32, far: f32, cosine: f32) -> f32 {
    let _ = (near, far, cosine);
    todo!("exercise 7.4")
}

/// Exercise 7.5, one of two: an estimate of what an interface sends, from one of its two rays.
///
/// `part` is the part that is reflected, from 0.02 to 0.98. `mirrored` and `refracted` are what both rays
/// would bring; look at one of them only. `chance` is a random number, uniform in [0, 1). The mean
/// of your estimates must be what both rays together would bring. The check takes many. See the
/// section "Two rays, or one".
pub fn one_of_two(part: f32, mirrored: f32, refracted: f32, chance: f32) -> f32 {
    let _ = (part, mirrored, refracted, chance);
    todo!("exercise 7.5")
}

/// Exercise 7.6, find the mistake: equation 2-2 for glass.
///
/// `naive::equation_2_2` has two constants where light has laws. Give what the eye sees, in the
/// medium of index `near`, of an interface to the medium of index `far`: `mirrored` is the radiance
/// that the mirror's ray brings, `refracted` the radiance that comes towards the interface inside of
/// the medium beyond it. Glass sends nothing of its own. You may use your `reflectance`. See the
/// sections "How much is reflected" and "Radiance in glass".
pub fn seen(near: f32, far: f32, cosine: f32, mirrored: Color, refracted: Color) -> Color {
    let _ = (near, far, cosine, mirrored, refracted);
    todo!("exercise 7.6")
}
