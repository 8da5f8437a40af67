//! Perfect mirrors.

use common::film::Color;
use glam::Vec3;

use crate::bsdf::{Bsdf, BsdfSample};
use crate::random::Random;

// ANCHOR: mirror
/// A surface that reflects in one direction only, on both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The part of the light that is reflected: each colour from 0 to 1.
    pub reflectance: Color,
}

impl Bsdf for Mirror {
    #[inline]
    fn eval(&self, _outgoing: Vec3, _incoming: Vec3) -> Color {
        Color::ZERO
    }

    #[inline]
    fn pdf(&self, _outgoing: Vec3, _incoming: Vec3) -> f32 {
        0.0
    }

    #[inline]
    fn sample(&self, outgoing: Vec3, _random: &Random) -> Option<BsdfSample> {
        let incoming = mirrored(outgoing);
        Some(BsdfSample { incoming, weight: self.reflectance, pdf: 1.0, is_delta: true })
    }

    #[inline]
    fn spreads(&self) -> bool {
        false
    }
}
// ANCHOR_END: mirror

/// The direction turned half round the normal.
#[inline]
pub fn mirrored(outgoing: Vec3) -> Vec3 {
    Vec3::new(-outgoing.x, -outgoing.y, outgoing.z)
}
