//! The chapter's hard cases: inputs on which the textbook's formulas fail and ours don't.
//!
//! Each trial makes its input from its number. What decides is independent of both formulas: the
//! linear scan over the same triangles, whole numbers, or `f64` from the same inputs.

#[cfg(test)]
mod builds;
mod cells;
mod places;
pub mod rays;
mod scan;
pub mod scenes;

use common::hard::{Case, UNLIMITED};

const CHAPTER: &str = "09-partitions";

/// All of them, in the order of the catalogue.
pub const CASES: &[Case] = &[
    Case {
        id: "AC-01",
        chapter: CHAPTER,
        input: "every kind of ray at every kind of scene",
        most: UNLIMITED,
        naive_fails: scan::any_naive,
        robust_fails: scan::any_robust,
    },
    Case {
        id: "AC-05",
        chapter: CHAPTER,
        input: "corners of any bits between good ones",
        most: UNLIMITED,
        naive_fails: scan::garbage_naive,
        robust_fails: scan::garbage_robust,
    },
    Case {
        id: "AC-06",
        chapter: CHAPTER,
        input: "rays in the planes that cut a k-d tree",
        most: UNLIMITED,
        naive_fails: scan::in_plane_naive,
        robust_fails: scan::in_plane_robust,
    },
    Case {
        id: "AC-07",
        chapter: CHAPTER,
        input: "cells a few floats wide, or very large",
        most: UNLIMITED,
        naive_fails: places::middle_naive,
        robust_fails: places::middle_robust,
    },
    Case {
        id: "AC-08",
        chapter: CHAPTER,
        input: "from cell to cell by way of corners",
        most: UNLIMITED,
        naive_fails: cells::walk_naive,
        robust_fails: cells::walk_robust,
    },
    Case {
        id: "AC-09",
        chapter: CHAPTER,
        input: "coordinates at a grid's two ends",
        most: UNLIMITED,
        naive_fails: places::index_naive,
        robust_fails: places::index_robust,
    },
    Case {
        id: "AC-10",
        chapter: CHAPTER,
        input: "grids along an axis, 0 of either sign",
        most: UNLIMITED,
        naive_fails: scan::axis_naive,
        robust_fails: scan::axis_robust,
    },
    Case {
        id: "AC-11",
        chapter: CHAPTER,
        input: "triangles on the corners of eight cells",
        most: UNLIMITED,
        naive_fails: scan::straddling_naive,
        robust_fails: scan::straddling_robust,
    },
    Case {
        id: "BX-03",
        chapter: CHAPTER,
        input: "edges and vertices, near and far",
        most: UNLIMITED,
        naive_fails: scan::edge_naive,
        robust_fails: scan::edge_robust,
    },
];

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    #[test]
    fn the_robust_formulas_hold_and_the_controls_fail() {
        let ledger = Ledger::of(CASES, 50_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }
}
