//! Surfaces that look equally bright from everywhere.

use std::f32::consts::FRAC_1_PI;

use common::film::Color;
use glam::Vec3;
use monte_carlo::warp::hemisphere;

use crate::bsdf::{Bsdf, BsdfSample};
use crate::random::{DIRECTION, Random};

// ANCHOR: lambert
/// A surface whose BRDF is the constant reflectance / π, on both sides.
///
/// J. H. Lambert, "Photometria" (1760).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert {
    /// The part of the light that is reflected, the albedo: each colour from 0 to 1.
    pub reflectance: Color,
}

impl Bsdf for Lambert {
    #[inline]
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        if same_side(outgoing, incoming) { self.reflectance * FRAC_1_PI } else { Color::ZERO }
    }

    #[inline]
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        if same_side(outgoing, incoming) { incoming.z.abs() * FRAC_1_PI } else { 0.0 }
    }

    #[inline]
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        if self.reflectance == Color::ZERO {
            return None;
        }
        let up = hemisphere::cosine(random.pair(DIRECTION));
        let incoming = up.with_z(up.z.copysign(outgoing.z));
        // (reflectance / π) · cosine / (cosine / π): all but the reflectance cancels.
        let pdf = up.z * FRAC_1_PI;
        Some(BsdfSample { incoming, weight: self.reflectance, pdf, is_delta: false })
    }

    #[inline]
    fn spreads(&self) -> bool {
        self.reflectance != Color::ZERO
    }

    #[inline]
    fn is_diffuse(&self) -> bool {
        true
    }
}
// ANCHOR_END: lambert

impl Lambert {
    /// A surface that reflects nothing.
    pub const BLACK: Self = Self { reflectance: Color::ZERO };

    /// A surface that reflects this part of each colour.
    pub const fn new(red: f32, green: f32, blue: f32) -> Self {
        Self { reflectance: Color::new(red, green, blue) }
    }
}

/// Whether both directions are on the same side of the surface, and not along it.
#[inline]
pub fn same_side(outgoing: Vec3, incoming: Vec3) -> bool {
    outgoing.z * incoming.z > 0.0
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::Vec3;

    use super::{Lambert, same_side};
    use crate::bsdf::Bsdf;
    use crate::bsdf::tests::check_sampling;
    use crate::random::Random;

    const CLAY: Lambert = Lambert::new(0.63, 0.25, 0.05);

    #[test]
    fn directions_follow_their_density_on_both_sides() {
        check_sampling(&CLAY, Vec3::new(0.6, 0.0, 0.8));
        check_sampling(&CLAY, Vec3::new(0.0, 0.96, -0.28));
    }

    #[test]
    fn the_page_s_worked_number() {
        // A cosine of 0.8, albedo 0.25: f = 0.25/π, the density is 0.8/π, and the weight is 0.25.
        let (outgoing, incoming) = (Vec3::Z, Vec3::new(0.6, 0.0, 0.8));
        let value = CLAY.eval(outgoing, incoming).y;
        let pdf = CLAY.pdf(outgoing, incoming);
        assert!((value - 0.079_577_47).abs() < 1e-7);
        assert!((pdf - 0.254_647_9).abs() < 1e-7);
        assert!((value * 0.8 / pdf - 0.25).abs() < 1e-7);
    }

    #[test]
    fn both_ways_are_the_same() {
        for trial in 0..1000 {
            let [one, other] = [125, 126].map(|seed| {
                CLAY.sample(Vec3::Z, &Random::of_trial(seed, trial)).expect("it reflects").incoming
            });
            assert_eq!(CLAY.eval(one, other), CLAY.eval(other, one));
            assert_eq!(CLAY.eval(one, -other), Color::ZERO, "nothing goes through");
        }
    }

    #[test]
    fn black_reflects_nothing() {
        assert_eq!(Lambert::BLACK.sample(Vec3::Z, &Random::of_trial(1, 1)), None);
        assert!(!Lambert::BLACK.spreads() && CLAY.spreads());
        assert!(!same_side(Vec3::Z, Vec3::X), "a direction along the surface");
    }
}
