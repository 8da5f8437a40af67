//! The hard cases of this chapter: inputs on which the textbook's formula fails and ours doesn't.

mod drift;
mod horizon;
mod origin;
#[cfg(feature = "native")]
mod picture;
mod stack;
mod waiting;

use common::hard::Case;
use common::sampler::Stream;
use glam::Vec3;
use ray_casting::direction::unit;

/// All of them, in the catalogue's order; those from WH-11 on were found while writing.
pub const CASES: &[Case] = &[
    origin::POWER_OF_TWO,
    drift::DRIFT,
    stack::STACK,
    horizon::SMOOTH,
    horizon::GRAZING,
    stack::ROUNDING,
    waiting::WAITING,
    origin::OWN_MIRROR,
    stack::DARK,
];

/// This chapter, as the ledger names it.
const CHAPTER: &str = "06-whitted";

#[cfg(feature = "native")]
pub use picture::picture;

/// A direction of length 1; not quite uniform, which no case needs.
fn direction(stream: &mut Stream) -> Vec3 {
    let mut component = || stream.between(-1.0, 1.0);
    let vector = Vec3::new(component(), component(), component());
    if vector.length() > 0.1 { unit(vector).unwrap_or(vector) } else { direction(stream) }
}

/// A direction of length 1 at right angles to another.
fn across(stream: &mut Stream, axis: Vec3) -> Vec3 {
    let other = direction(stream);
    let across = other - other.dot(axis) * axis;
    if across.length() > 0.1 { unit(across).unwrap_or(across) } else { self::across(stream, axis) }
}

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    #[test]
    fn the_robust_formulas_hold_and_the_controls_fail() {
        let ledger = Ledger::of(CASES, 50_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }

    /// `cargo test --release -p whitted -- --ignored`
    #[test]
    #[ignore = "takes a minute"]
    fn ten_million_trials() {
        let ledger = Ledger::of(CASES, 10_000_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }
}
