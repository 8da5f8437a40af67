//! The chapter's hard cases: inputs on which the printed formulas fail and ours don't.
//!
//! A trial's number makes its input. What decides is independent of both formulas: `f64` arithmetic
//! on the same `f32` input, or an integral whose value is known.

mod draw;
mod lamp;
mod lobe;
mod opposite;
mod picture;
pub(crate) mod quadrature;
mod rim;
mod vanishing;

use common::hard::Case;

pub use picture::picture;

/// All of them, in the catalogue's order.
pub const CASES: &[Case] =
    &[opposite::HALF, lobe::POWER, lamp::NEAR, vanishing::NORMAL, quadrature::ENERGY, rim::BEHIND];

/// This chapter, as the ledger names it.
const CHAPTER: &str = "04-blinn-phong";

/// Half the distance from 1 to the next `f32`: what one rounding can do to a number near 1.
const U: f64 = f32::EPSILON as f64 / 2.0;

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    #[test]
    fn the_robust_formulas_hold_and_the_controls_fail() {
        let ledger = Ledger::of(CASES, 50_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }

    #[test]
    #[ignore = "takes a minute: cargo test --release -p blinn-phong -- --ignored"]
    fn not_once_in_ten_million() {
        let ledger = Ledger::of(CASES, 10_000_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }
}
