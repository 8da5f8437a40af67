//! The chapter's hard cases: inputs on which the textbook's lines fail and ours don't.
//!
//! Each trial makes its input from its number. What decides is the linear scan over the same
//! triangles, the definition of a tree, or the same question at another scale.

mod building;
mod same;

use common::hard::{Case, UNLIMITED};

const CHAPTER: &str = "10-bvh";

/// All of them, in the order of the catalogue.
pub const CASES: &[Case] = &[
    Case {
        id: "AC-01",
        chapter: CHAPTER,
        input: "every kind of ray at every kind of scene",
        most: UNLIMITED,
        naive_fails: same::any_naive,
        robust_fails: same::any_robust,
    },
    Case {
        id: "AC-02",
        chapter: CHAPTER,
        input: "things with one centre, or in one place",
        most: building::LONG,
        naive_fails: building::copies_naive,
        robust_fails: building::copies_robust,
    },
    Case {
        id: "AC-03",
        chapter: CHAPTER,
        input: "boxes 2^-100 to 2^100 times as large",
        most: building::LONG,
        naive_fails: building::scale_naive,
        robust_fails: building::scale_robust,
    },
    Case {
        id: "AC-04",
        chapter: CHAPTER,
        input: "each half as far away as the one before",
        most: building::LONGER,
        naive_fails: building::progression_naive,
        robust_fails: building::progression_robust,
    },
    Case {
        id: "AC-05",
        chapter: CHAPTER,
        input: "corners of any bits between good ones",
        most: UNLIMITED,
        naive_fails: same::garbage_naive,
        robust_fails: same::garbage_robust,
    },
    Case {
        id: "AC-12",
        chapter: CHAPTER,
        input: "several triangles in one place",
        most: UNLIMITED,
        naive_fails: same::ties_naive,
        robust_fails: same::ties_robust,
    },
];

#[cfg(test)]
mod tests {
    use common::hard::{Case, Ledger};

    use super::CASES;

    #[test]
    fn the_robust_formulas_hold_and_the_controls_fail() {
        let ledger = Ledger::of(CASES, 50_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }

    /// `cargo test --release -p bvh -- --ignored`
    #[test]
    #[ignore = "takes a minute"]
    fn ten_million_rays_find_what_the_scan_finds() {
        let rays: Vec<Case> = CASES.iter().filter(|case| case.id == "AC-01").copied().collect();
        let ledger = Ledger::of(&rays, 10_000_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }
}
