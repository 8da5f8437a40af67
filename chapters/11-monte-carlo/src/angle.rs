//! The angle between two directions.

use common::math::atan2;
use glam::Vec3;

// ANCHOR: between
/// The angle between two vectors, in [0, π]; they need not have length 1.
///
/// An arc cosine is NaN as soon as the cosine is rounded above 1, and near 1 it has half its digits
/// (hard case MC-06).
#[inline]
pub fn between(one: Vec3, other: Vec3) -> f32 {
    atan2(one.cross(other).length(), one.dot(other))
}
// ANCHOR_END: between

#[cfg(test)]
mod tests {
    use std::f32::consts::{FRAC_PI_2, PI};

    use glam::Vec3;

    use super::between;

    #[test]
    fn known_angles() {
        assert_eq!(between(Vec3::X, Vec3::X), 0.0);
        assert_eq!(between(Vec3::X, 2.0 * Vec3::Y), FRAC_PI_2);
        assert_eq!(between(Vec3::Z, Vec3::NEG_Z), PI);
        assert!((between(Vec3::Z, Vec3::new(1e-5, 0.0, 1.0)) - 1e-5).abs() < 1e-11);
    }
}
