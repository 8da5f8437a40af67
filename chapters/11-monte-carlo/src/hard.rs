//! The hard cases of this chapter: inputs on which the textbook's formula fails and ours doesn't.

mod choices;
mod convergence;
mod directions;
mod numbers;
mod picture;
mod power;
mod sums;

use common::film::Film;
use common::hard::Case;

/// All of them, in the catalogue's order.
pub const CASES: &[Case] = &[
    directions::FRAME,
    numbers::UNIT,
    directions::RIM,
    directions::NO_DENSITY,
    sums::VARIANCE,
    sums::LONG,
    directions::ANGLE,
    choices::ENDS,
    power::POWER,
    numbers::STRATUM,
    convergence::SLOPE,
    directions::CAP,
];

/// Directions to a ball that is far away: by the textbook's formula, and by ours.
pub fn picture() -> Film {
    picture::picture()
}

/// This chapter, as the ledger names it.
const CHAPTER: &str = "11-monte-carlo";

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    fn check(trials: u64) {
        let ledger = Ledger::of(CASES, trials);
        assert!(ledger.broken().is_empty(), "{ledger}");
    }

    #[test]
    fn the_naive_fails_and_the_robust_does_not() {
        check(50_000);
    }

    #[test]
    #[ignore = "takes minutes: cargo test --release -p monte-carlo -- --ignored"]
    fn not_once_in_a_hundred_million() {
        check(100_000_000);
    }
}
