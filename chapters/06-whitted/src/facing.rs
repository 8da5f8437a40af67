//! Two mirrors face to face without any geometry: what they send has a closed form.

use common::film::Color;
use common::tally::Tally;

use crate::mirror::MIRROR_RAYS;
use crate::scatter::{Branch, Scatter, Scattered};

/// Two equal mirrors, one before the other, and a ray that goes to and fro between them for ever.
/// The ray is the number of mirrors that it met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facing {
    /// The radiance each sends by itself.
    pub light: f32,
    /// What each returns of the other's, in [0, 1].
    pub mirror: f32,
}

impl Scatter for Facing {
    type Ray = u64;

    fn scatter<T: Tally>(&self, ray: &u64, _tally: &mut T) -> Scattered<u64> {
        let weight = Color::splat(self.mirror);
        let branch = Branch { ray: ray + 1, weight, event: &MIRROR_RAYS };
        Scattered::with(Color::splat(self.light), Some(branch))
    }
}

// ANCHOR: series
/// 1 + ρ + ρ² + … + ρⁿ, for n = `depth`: each term is a mirror further away.
///
/// Not by the closed form (1 - ρⁿ⁺¹) / (1 - ρ), which cancels where ρ is near 1, and not term by
/// term, which is what it is to judge: the first m terms and ρᵐ give the first 2 m.
pub fn series(mirror: f64, depth: u32) -> f64 {
    let (mut sum, mut power) = (0.0, 1.0);
    let terms = u64::from(depth) + 1;
    for bit in (0..64 - terms.leading_zeros()).rev() {
        sum += sum * power;
        power *= power;
        if terms >> bit & 1 == 1 {
            sum += power;
            power *= mirror;
        }
    }
    sum
}
// ANCHOR_END: series

#[cfg(test)]
mod tests {
    use super::series;

    #[test]
    fn the_series_by_hand_and_by_its_closed_form() {
        assert_eq!(series(0.5, 0), 1.0);
        assert_eq!(series(0.5, 1), 1.5);
        assert_eq!(series(0.5, 3), 1.875);
        assert_eq!(series(1.0, 999_999), 1e6);
        assert_eq!(series(0.0, 7), 1.0);
        for depth in 0..200 {
            let rest: f64 = (0..=depth).map(|_| 0.9).product();
            let closed = (1.0 - rest) / (1.0 - 0.9);
            assert!((series(0.9, depth) - closed).abs() < 1e-12, "{depth}");
        }
    }
}
