//! Uniform directions of a cap: all that are within an angle of z.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};

use super::disk;

// ANCHOR: cap
/// The directions within an angle θ of the z axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cap {
    /// 1 - cos θ, in [0, 2]: the cap's height. The cosine itself would round a small cap away.
    pub height: f32,
}

impl Cap {
    /// The cap in which a ball of radius 1 is seen from a `distance` of its centre, which is above 1,
    /// in units of its radius. `None` from inside, and for NaN.
    ///
    /// With s = 1 / distance, the sine of θ, the height is s² / (1 + √(1 - s²)): the schoolbook's
    /// 1 - √(1 - s²) has no digit left from 4096 on (hard case LS-01).
    #[inline]
    pub fn of_ball(distance: f32) -> Option<Self> {
        if !(distance > 1.0) {
            return None;
        }
        let sine = 1.0 / distance;
        // 1 - s is (d - 1) / d: close to the ball, d - 1 has digits that 1 / d has lost.
        let cosine = ((distance - 1.0) * sine * (1.0 + sine)).sqrt();
        Some(Self { height: sine * sine / (1.0 + cosine) })
    }

    /// Its solid angle, in steradians.
    #[inline]
    pub fn solid_angle(&self) -> f32 {
        TAU * self.height
    }

    /// A direction in it, all with the density one over its solid angle.
    #[inline]
    pub fn sample(&self, u: Vec2) -> Vec3 {
        let below = u.x * self.height;
        // sin² = (1 - cos)(1 + cos), with 1 - cos at hand.
        let radius = (below * (2.0 - below)).max(0.0).sqrt();
        (radius * disk::direction(TAU * u.y)).extend(1.0 - below)
    }
}
// ANCHOR_END: cap
