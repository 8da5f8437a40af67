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
