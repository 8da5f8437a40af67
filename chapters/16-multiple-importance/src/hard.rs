//! The hard cases of this chapter: inputs on which the textbook's formula fails and ours doesn't.

mod densities;
mod estimates;
mod weights;

use common::hard::Case;

/// All of them, in the catalogue's order.
pub const CASES: &[Case] = &[
    weights::SQUARES,
    weights::ZEROS,
    weights::LIMITS,
    weights::MANY,
    densities::MET_AGAIN,
    estimates::AGREE,
];

/// This chapter, as the ledger names it.
const CHAPTER: &str = "16-multiple-importance";

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
        check(70_000);
    }

    #[test]
    #[ignore = "takes minutes: cargo test --release -p multiple-importance -- --ignored"]
    fn not_once_in_ten_million() {
        check(10_000_000);
    }
}
