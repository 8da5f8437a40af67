//! The hard cases of this chapter: inputs on which the textbook's roulette fails and ours doesn't.

mod faint;
mod furnace;
mod white;

use common::hard::Case;

/// All of them, in the catalogue's order.
pub const CASES: &[Case] = &[furnace::FURNACE, faint::BLACK, faint::TINY, white::ENDLESS];

/// This chapter, as the ledger names it.
const CHAPTER: &str = "14-russian-roulette";

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
        check(20_000);
    }

    #[test]
    #[ignore = "takes minutes: cargo test --release -p russian-roulette -- --ignored"]
    fn not_once_in_a_hundred_million() {
        check(100_000_000);
    }
}
