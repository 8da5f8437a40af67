//! How a surface scatters light: what every material can be asked.
//!
//! Directions are those of the surface's own frame, have length 1 and point away from the surface: z
//! is the outward normal, whichever side the light is on.

use common::film::Color;
use common::plan::Effect;
use glam::Vec3;

use crate::random::Random;

// ANCHOR: bsdf
/// A bidirectional scattering distribution function.
///
/// F. E. Nicodemus and others, "Geometrical considerations and nomenclature for reflectance" (1977);
/// the three questions are Veach's ("Robust Monte Carlo methods for light transport simulation", 1997,
/// section 3.7).
pub trait Bsdf: Copy + Send + Sync {
    /// Radiance that leaves towards `outgoing` for each unit of irradiance from `incoming`, per
    /// steradian. What goes in one direction alone, as from a mirror, is not in it.
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color;

    /// The density with which [`Bsdf::sample`] chooses `incoming`, per steradian.
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32;

    /// A direction from which light may come; `None` when none of it leaves towards `outgoing`.
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample>;

    /// Whether [`Bsdf::eval`] is above 0 for any directions. Where it isn't, light that was looked
    /// for elsewhere finds no way to the eye.
    fn spreads(&self) -> bool;
}
// ANCHOR_END: bsdf

// ANCHOR: sample
/// A direction a material chose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfSample {
    /// Where the light comes from.
    pub incoming: Vec3,
    /// `eval` · |cosine| / `pdf`: what becomes of the radiance that comes from there.
    pub weight: Color,
    /// The density it was chosen with, per steradian; the probability where `is_delta`.
    pub pdf: f32,
    /// Whether it was the only direction there is, so that there is no density.
    pub is_delta: bool,
}
// ANCHOR_END: sample

// ANCHOR: material
/// A scattering function that a scene may ask for.
pub trait Material: Bsdf {
    /// # Errors
    /// When it would make light, or is no number.
    fn check(&self) -> Result<(), MaterialError>;

    /// What has to be simulated for it, beyond light that is scattered in all directions.
    fn effect(&self) -> Option<Effect>;

    /// Whether it sends any light on.
    fn reflects(&self) -> bool;
}
// ANCHOR_END: material

/// Why a material can't be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MaterialError {
    /// It would make light, or is no number.
    #[error("the reflectance of a surface must lie from 0 to 1 in every colour")]
    Reflectance,
    /// Its light is no amount of light.
    #[error("the radiance that a surface emits must be finite and at least 0 in every colour")]
    Emission,
    /// Its roughness is no roughness.
    #[error("the roughness of a surface must lie from 0 to 1")]
    Roughness,
}

/// # Errors
/// When a surface would reflect more light than it gets.
pub fn check_reflectance(reflectance: Color) -> Result<(), MaterialError> {
    let valid = reflectance.to_array().iter().all(|part| (0.0..=1.0).contains(part));
    if valid { Ok(()) } else { Err(MaterialError::Reflectance) }
}
