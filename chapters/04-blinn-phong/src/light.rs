//! Lamps, and what arrives of them.

use common::film::Color;
use glam::Vec3;
use ray_casting::direction::unit;

// ANCHOR: light
/// A lamp without extent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// At a place, and sending alike in all directions.
    Point {
        /// Where it is.
        position: Vec3,
        /// What arrives at distance d is `color / (falloff[0] + falloff[1] d + falloff[2] d²)`.
        color: Color,
        /// The constant, linear and quadratic part; `[1, 0, 0]` does not fall off, as in the report.
        falloff: [f32; 3],
    },
    /// So far away that all its light runs one way.
    Directional {
        /// Towards the lamp, of length 1.
        toward: Vec3,
        /// What arrives.
        color: Color,
    },
}
// ANCHOR_END: light

/// A [`Light::Point`] that does not fall off.
pub const STEADY: [f32; 3] = [1.0, 0.0, 0.0];

/// The brightest a lamp may be, in each channel.
pub const BRIGHTEST: f32 = 1e9;

/// What a fall-off divides by at least. A point lamp has no size, so nearness has no end to what
/// arrives of it; an `f32` has.
const LEAST_FALLOFF: f32 = 1e-18;

/// What arrives of a lamp at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arriving {
    /// The direction to the lamp, of length 1.
    pub toward: Vec3,
    /// How far away it is; infinite for a directional one.
    pub distance: f32,
    /// How much of red, green and blue arrives, on a surface that faces the lamp.
    pub color: Color,
}

/// Why a lamp is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LightError {
    /// A coordinate is infinite or no number.
    #[error("a lamp's place needs three finite numbers")]
    Place,
    /// All light that runs one way has to run some way.
    #[error("the direction to a lamp far away needs three finite numbers, not all of them 0")]
    Direction,
    /// Negative light, or more than can be added up.
    #[error("a lamp's colour needs three numbers from 0 to 1000000000")]
    Color,
    /// A division by zero at every distance, or by less.
    #[error("a lamp's fall-off needs three finite numbers from 0 up, not all of them 0")]
    Falloff,
}

impl Light {
    /// A lamp at a place, whose light does not fall off.
    pub fn steady(position: Vec3, color: Color) -> Self {
        Self::Point { position, color, falloff: STEADY }
    }

    /// A lamp far away in this direction, of any length but 0.
    ///
    /// # Errors
    /// [`LightError::Direction`] where there is none.
    pub fn far(direction: Vec3, color: Color) -> Result<Self, LightError> {
        let toward = unit(direction).ok_or(LightError::Direction)?;
        Ok(Self::Directional { toward, color })
    }

    /// Whether it sends any light.
    pub fn is_on(&self) -> bool {
        let (Self::Point { color, .. } | Self::Directional { color, .. }) = *self;
        color != Color::ZERO
    }

    /// Whether it can be drawn with: that nothing that arrives of it is negative, infinite or NaN.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn check(&self) -> Result<(), LightError> {
        let (Self::Point { color, .. } | Self::Directional { color, .. }) = *self;
        if !color.to_array().iter().all(|channel| (0.0..=BRIGHTEST).contains(channel)) {
            return Err(LightError::Color);
        }
        match *self {
            Self::Directional { toward, .. } => {
                unit(toward).map(|_| ()).ok_or(LightError::Direction)
            }
            Self::Point { position, .. } if !position.is_finite() => Err(LightError::Place),
            Self::Point { falloff, .. } => {
                let sound = falloff.iter().all(|part| (0.0..=f32::MAX).contains(part));
                let some = falloff.iter().any(|&part| part > 0.0);
                if sound && some { Ok(()) } else { Err(LightError::Falloff) }
            }
        }
    }

    // ANCHOR: at
    /// What arrives at `point`. None where the lamp itself is, or so near that the fall-off rounds
    /// to 0: light from no direction.
    pub fn at(&self, point: Vec3) -> Option<Arriving> {
        match *self {
            Self::Directional { toward, color } => {
                Some(Arriving { toward, distance: f32::INFINITY, color })
            }
            Self::Point { position, color, falloff: [constant, linear, quadratic] } => {
                let toward = unit(position - point)?;
                let distance = (position - point).dot(toward).min(f32::MAX);
                let falloff = constant + distance * (linear + distance * quadratic);
                let color = color / falloff.max(LEAST_FALLOFF);
                (falloff > 0.0).then_some(Arriving { toward, distance, color })
            }
        }
    }
    // ANCHOR_END: at
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::Vec3;

    use super::{Light, LightError, STEADY};

    const COLOR: Color = Color::new(0.5, 2.0, 8.0);

    fn lamp(falloff: [f32; 3]) -> Light {
        Light::Point { position: Vec3::new(3.0, -2.0, 7.0), color: COLOR, falloff }
    }

    #[test]
    fn what_arrives_by_hand() {
        // From (1, 1, 1) it is (2, -3, 6) to the lamp, 7 units long.
        let arriving = lamp([0.5, 0.25, 0.125]).at(Vec3::ONE).expect("it is not at the lamp");
        assert_eq!(arriving.distance, 7.0);
        assert!((arriving.toward - Vec3::new(2.0, -3.0, 6.0) / 7.0).length() < 1e-6);
        // 0.5 + 0.25 · 7 + 0.125 · 49 = 8.375
        assert!((arriving.color - COLOR / 8.375).length() < 1e-6);
        assert_eq!(lamp(STEADY).at(Vec3::ONE).expect("as above").color, COLOR);
    }

    #[test]
    fn a_lamp_far_away_is_the_same_everywhere() {
        let sun = Light::far(Vec3::new(0.0, 3.0, 4.0) * 1e25, COLOR).expect("a direction");
        assert_eq!(sun.at(Vec3::ZERO), sun.at(Vec3::splat(1e6)));
        let toward = sun.at(Vec3::ZERO).expect("a sun is nowhere").toward;
        assert!((toward - Vec3::new(0.0, 0.6, 0.8)).length() < 1e-6);
    }

    #[test]
    fn nearness_has_an_end() {
        let lamp = Light::Point { position: Vec3::ZERO, color: COLOR, falloff: [0.0, 0.0, 1.0] };
        assert_eq!(lamp.at(Vec3::ZERO), None);
        for exponent in -45..=38 {
            let point = Vec3::new(0.0, common::math::pow(10.0, exponent as f32), 0.0);
            let color = lamp.at(point).map_or(Color::ZERO, |arriving| arriving.color);
            assert!(color.is_finite(), "10^{exponent}: {color}");
        }
    }

    #[test]
    fn the_ends_of_f32_arrive_as_nothing_or_as_something_finite() {
        let far = Vec3::splat(f32::MAX);
        for position in [far, -far, Vec3::ZERO] {
            for falloff in [STEADY, [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [f32::MAX; 3]] {
                let lamp = Light::Point { position, color: COLOR, falloff };
                let arriving = lamp.at(0.9 * far);
                assert!(arriving.is_none_or(|it| it.color.is_finite() && it.toward.is_finite()));
            }
        }
    }

    #[test]
    fn lamps_that_are_none() {
        assert_eq!(lamp(STEADY).check(), Ok(()));
        for falloff in [[0.0; 3], [1.0, -1e-9, 0.0], [f32::NAN, 1.0, 1.0], [f32::INFINITY; 3]] {
            assert_eq!(lamp(falloff).check(), Err(LightError::Falloff), "{falloff:?}");
        }
        for color in [Color::NAN, -COLOR, COLOR * 1e9, Color::INFINITY] {
            assert_eq!(Light::steady(Vec3::ONE, color).check(), Err(LightError::Color));
        }
        assert_eq!(Light::steady(Vec3::NAN, COLOR).check(), Err(LightError::Place));
        for direction in [Vec3::ZERO, Vec3::NAN, Vec3::INFINITY] {
            assert_eq!(Light::far(direction, COLOR), Err(LightError::Direction));
            let light = Light::Directional { toward: direction, color: COLOR };
            assert_eq!(light.check(), Err(LightError::Direction));
        }
    }
}
