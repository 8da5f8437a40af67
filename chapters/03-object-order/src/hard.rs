//! The chapter's hard cases: group RA of the catalogue.

mod coverage;
mod depth;
mod order;
mod picture;
mod straddle;

use common::hard::{Case, UNLIMITED};

pub use coverage::{Fan, fan};
pub use picture::picture;

const CHAPTER: &str = "03-object-order";

/// All of them.
pub const CASES: [Case; 5] = [
    Case {
        id: "RA-01",
        chapter: CHAPTER,
        input: "a sample on an edge that triangles share: covered once",
        most: UNLIMITED,
        naive_fails: coverage::float_edges_fail,
        robust_fails: coverage::fixed_edges_fail,
    },
    Case {
        id: "RA-02",
        chapter: CHAPTER,
        input: "two planes 0.001 % apart, up to 10^7 away, near plane at 0.1",
        most: UNLIMITED,
        naive_fails: depth::standard_fails,
        robust_fails: depth::reversed_fails,
    },
    Case {
        id: "RA-03",
        chapter: CHAPTER,
        input: "a triangle that reaches behind the eye",
        most: UNLIMITED,
        naive_fails: straddle::dividing_first_fails,
        robust_fails: straddle::clipping_first_fails,
    },
    Case {
        id: "RA-04",
        chapter: CHAPTER,
        input: "random triangles: both orders see the same one, equally deep",
        most: UNLIMITED,
        naive_fails: order::affine_fails,
        robust_fails: order::perspective_fails,
    },
    Case {
        id: "RA-05",
        chapter: CHAPTER,
        input: "corners up to 2^22 pixels outside the film",
        most: UNLIMITED,
        naive_fails: coverage::narrow_edges_fail,
        robust_fails: coverage::wide_edges_fail,
    },
];

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    #[test]
    fn every_case_holds() {
        let ledger = Ledger::of(&CASES, 30_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }

    #[test]
    #[ignore = "10^8 trials take minutes"]
    fn every_case_holds_a_hundred_million_times() {
        let ledger = Ledger::of(&CASES, 100_000_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }
}
