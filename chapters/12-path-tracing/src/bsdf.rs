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

    /// Whether what leaves the surface is equally bright in all directions of a side, so that an
    /// estimate for one of them holds for all.
    fn is_diffuse(&self) -> bool {
        false
    }
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

#[cfg(test)]
pub(crate) mod tests {
    use common::film::Color;
    use common::math::{cos, sin};
    use common::stats::estimate::{Estimate, z_test};
    use common::stats::running::Running;
    use glam::Vec3;

    use super::{Bsdf, MaterialError, check_reflectance};
    use crate::random::Random;

    /// The integral of `value` over all directions, by the midpoints of a fine grid.
    fn integral(value: impl Fn(Vec3) -> f64) -> f64 {
        const ROWS: u32 = 200;
        const COLUMNS: u32 = 100;
        let mut sum = 0.0;
        for row in 0..ROWS {
            let z = 2.0 * (row as f32 + 0.5) / ROWS as f32 - 1.0;
            let radius = (1.0 - z * z).sqrt();
            for column in 0..COLUMNS {
                let angle = std::f32::consts::TAU * (column as f32 + 0.5) / COLUMNS as f32;
                sum += value(Vec3::new(radius * cos(angle), radius * sin(angle), z));
            }
        }
        sum * 4.0 * std::f64::consts::PI / f64::from(ROWS * COLUMNS)
    }

    /// Fails where the density isn't one, where samples don't follow it, or where their weights don't
    /// have the mean of what is reflected.
    pub(crate) fn check_sampling(bsdf: &impl Bsdf, outgoing: Vec3) {
        let density = |incoming| f64::from(bsdf.pdf(outgoing, incoming));
        assert!((integral(density) - 1.0).abs() < 1e-3, "the density's integral");
        let values: [fn(Vec3) -> f32; 4] = [|w| w.x, |w| w.y * w.y, |w| w.z, |w| w.x * w.z];
        for value in values {
            let right = integral(|incoming| density(incoming) * f64::from(value(incoming)));
            check_mean(right, |trial| {
                let sample = bsdf.sample(outgoing, &Random::of_trial(123, trial));
                sample.map_or(0.0, |sample| f64::from(value(sample.incoming)))
            });
        }
        let reflected =
            integral(|incoming| f64::from(bsdf.eval(outgoing, incoming).y * incoming.z.abs()));
        check_mean(reflected, |trial| {
            let sample = bsdf.sample(outgoing, &Random::of_trial(124, trial));
            sample.map_or(0.0, |sample| f64::from(sample.weight.y))
        });
    }

    fn check_mean(right: f64, sample: impl Fn(u64) -> f64) {
        let samples: Running = (0..20_000).map(sample).collect();
        let estimate = Estimate::of(&samples).expect("many");
        let close = (estimate.mean - right).abs() < 1e-3;
        let test = z_test(&estimate, &Estimate::exact(right));
        assert!(close || test.p_value > 1e-5, "{estimate:?} is not {right}");
    }

    #[test]
    fn a_reflectance_is_from_zero_to_one() {
        assert!(check_reflectance(Color::new(0.0, 0.5, 1.0)).is_ok());
        for blue in [-0.001, 1.001, f32::NAN, f32::INFINITY] {
            let told = check_reflectance(Color::new(0.5, 0.5, blue));
            assert_eq!(told, Err(MaterialError::Reflectance));
        }
    }
}
