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

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::Vec3;

    use super::Mirror;
    use crate::bsdf::Bsdf;
    use crate::random::Random;

    #[test]
    fn one_direction_on_either_side() {
        let mirror = Mirror { reflectance: Color::new(0.9, 0.8, 0.7) };
        for z in [0.8, -0.8] {
            let outgoing = Vec3::new(0.36, -0.48, z);
            let sample = mirror.sample(outgoing, &Random::of_trial(1, 1)).expect("it reflects");
            assert_eq!(sample.incoming, Vec3::new(-0.36, 0.48, z));
            assert_eq!((sample.weight, sample.pdf), (mirror.reflectance, 1.0));
            assert!(sample.is_delta);
            assert_eq!(mirror.eval(outgoing, sample.incoming), Color::ZERO);
            assert_eq!(mirror.pdf(outgoing, sample.incoming), 0.0);
        }
        assert!(!mirror.spreads());
    }
}
