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
    fn many_roundings_are_hardly_more_than_many_times_one() {
        for count in [1, 3, 7, 32] {
            let rounded = f64::from(count) * f64::from(f32::EPSILON) / 2.0;
            let exact = rounded / (1.0 - rounded);
            assert!((f64::from(gamma(count)) / exact - 1.0).abs() < 1e-7, "{count}");
        }
        assert_eq!(gamma(0), 0.0);
    }
}
