//! How much roundings can add up to, and points that know it.

use glam::Vec3;

// ANCHOR: gamma
/// What `count` roundings in a row can change of a number at most, as a part of it: n u / (1 - n u)
/// with u = 2⁻²⁴, half the distance from 1 to the next `f32`.
///
/// Higham, "Accuracy and Stability of Numerical Algorithms" (second edition, 2002), lemma 3.1.
pub const fn gamma(count: u32) -> f32 {
    let rounded = count as f32 * f32::EPSILON / 2.0;
    rounded / (1.0 - rounded)
}
// ANCHOR_END: gamma

/// A point of a surface, and how far it may be from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// The point.
    pub point: Vec3,
    /// How far from the surface it may be, along each axis.
    pub error: Vec3,
}

#[cfg(test)]
mod tests {
    use super::gamma;

    #[test]
    fn three_roundings_are_hardly_more_than_three_times_one() {
        assert!(gamma(3) > 3.0 * gamma(1) && gamma(3) < 3.000_001 * gamma(1));
        assert_eq!(gamma(0), 0.0);
    }
}
