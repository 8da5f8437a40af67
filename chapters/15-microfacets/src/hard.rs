//! The hard cases of this chapter: inputs on which the textbook's formula fails and ours doesn't.

mod blind;
mod distribution;
mod glass;
mod half;
mod integral;
mod lost;
mod metal;
mod picture;
mod smooth;
mod visible;

use common::film::Film;
use common::hard::Case;
use common::sampler::Stream;
use glam::Vec3;

/// All of them, in the catalogue's order.
pub const CASES: &[Case] = &[
    distribution::DENSITY,
    smooth::SMOOTH,
    distribution::MASKING,
    half::HALF,
    visible::EXTREME,
    visible::RIM,
    visible::WEIGHT,
    integral::ONE,
    glass::TWO_WAYS,
    blind::BLIND,
    lost::LOST,
    metal::METAL,
];

/// D around the normal of a surface that is nearly smooth: by the textbook's formula, and by ours.
pub fn picture() -> Film {
    picture::picture()
}

/// This chapter, as the ledger names it.
const CHAPTER: &str = "15-microfacets";

/// A number between two powers of ten, each power as often as another.
fn magnitude(stream: &mut Stream, low: f32, high: f32) -> f32 {
    common::math::pow(10.0, stream.between(low, high))
}

/// The direction whose height is `z`, turned by `turn`.
fn at(z: f32, turn: f32) -> Vec3 {
    let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    Vec3::new(radius * common::math::cos(turn), radius * common::math::sin(turn), z)
}

/// Whether `found` is off by more than a part `tolerance` of `right`, or no number.
fn off(found: f32, right: f64, tolerance: f64) -> bool {
    !((f64::from(found) - right).abs() <= tolerance * right.abs())
}

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    #[test]
    fn the_naive_fails_and_the_robust_does_not() {
        let ledger = Ledger::of(CASES, 50_000);
        assert!(ledger.broken().is_empty(), "{ledger}");
    }

    #[test]
    #[ignore = "takes minutes: cargo test --release -p microfacets -- --ignored"]
    fn not_once_in_a_hundred_million() {
        let ledger = Ledger::of(CASES, 100_000_000);
        assert!(ledger.broken().is_empty(), "{ledger}");
    }
}
