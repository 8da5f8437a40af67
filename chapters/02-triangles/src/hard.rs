//! The chapter's hard cases: inputs on which the textbook's formulas fail and ours don't.
//!
//! Each trial makes its input from its number. What decides is independent of both formulas: exact
//! integers, f64 from the same inputs, or the same question put in another way.

pub(crate) mod aimed;
mod answers;
mod extremes;
mod lattice;
mod picture;
mod same;
pub(crate) mod shapes;
mod surfaces;

use common::hard::{Case, UNLIMITED};

pub use picture::picture;

const CHAPTER: &str = "02-triangles";

/// All of them, in the order of the catalogue.
pub const CASES: &[Case] = &[
    Case {
        id: "TR-01",
        chapter: CHAPTER,
        input: "small triangles, hit in the middle",
        most: UNLIMITED,
        naive_fails: extremes::small_naive,
        robust_fails: extremes::small_robust,
    },
    Case {
        id: "TR-02",
        chapter: CHAPTER,
        input: "from inside a closed mesh to its edges",
        most: UNLIMITED,
        naive_fails: aimed::edge_naive,
        robust_fails: aimed::edge_robust,
    },
    Case {
        id: "TR-03",
        chapter: CHAPTER,
        input: "the corners in another order",
        most: UNLIMITED,
        naive_fails: same::order_naive,
        robust_fails: same::order_robust,
    },
    Case {
        id: "TR-04",
        chapter: CHAPTER,
        input: "from inside a closed mesh to its vertices",
        most: UNLIMITED,
        naive_fails: aimed::vertex_naive,
        robust_fails: aimed::vertex_robust,
    },
    Case {
        id: "TR-05",
        chapter: CHAPTER,
        input: "rays along slim triangles, far away",
        most: UNLIMITED,
        naive_fails: extremes::grazing_naive,
        robust_fails: extremes::grazing_robust,
    },
    Case {
        id: "TR-06",
        chapter: CHAPTER,
        input: "three corners exactly in line",
        most: UNLIMITED,
        naive_fails: extremes::in_line_naive,
        robust_fails: extremes::in_line_robust,
    },
    Case {
        id: "TR-07",
        chapter: CHAPTER,
        input: "rays in the triangle's own plane",
        most: UNLIMITED,
        naive_fails: extremes::in_plane_naive,
        robust_fails: extremes::in_plane_robust,
    },
    Case {
        id: "TR-08",
        chapter: CHAPTER,
        input: "huge triangles, 10^17 to 10^37 across",
        most: UNLIMITED,
        naive_fails: extremes::huge_naive,
        robust_fails: extremes::huge_robust,
    },
    Case {
        id: "TR-09",
        chapter: CHAPTER,
        input: "tiny triangles, 10^-30 to 10^-6 across",
        most: UNLIMITED,
        naive_fails: extremes::tiny_naive,
        robust_fails: extremes::tiny_robust,
    },
    Case {
        id: "TR-10",
        chapter: CHAPTER,
        input: "a closed mesh far from the origin",
        most: UNLIMITED,
        naive_fails: aimed::far_naive,
        robust_fails: aimed::far_robust,
    },
    Case {
        id: "TR-11",
        chapter: CHAPTER,
        input: "normals of slivers",
        most: UNLIMITED,
        naive_fails: surfaces::sliver_naive,
        robust_fails: surfaces::sliver_robust,
    },
    Case {
        id: "TR-12",
        chapter: CHAPTER,
        input: "NaN and infinity in rays and corners",
        most: answers::BROKEN_INPUTS,
        naive_fails: answers::broken_naive,
        robust_fails: answers::broken_robust,
    },
    Case {
        id: "TR-13",
        chapter: CHAPTER,
        input: "mesh files that are hard to read",
        most: answers::FILES.len() as u64,
        naive_fails: answers::file_naive,
        robust_fails: answers::file_robust,
    },
    Case {
        id: "TR-14",
        chapter: CHAPTER,
        input: "vertex normals among faces without area",
        most: UNLIMITED,
        naive_fails: surfaces::normals_naive,
        robust_fails: surfaces::normals_robust,
    },
    Case {
        id: "TR-15",
        chapter: CHAPTER,
        input: "clear hits and misses, by whole numbers",
        most: UNLIMITED,
        naive_fails: lattice::clear_naive,
        robust_fails: lattice::clear_robust,
    },
    Case {
        id: "X-07",
        chapter: CHAPTER,
        input: "edge functions that nearly cancel",
        most: UNLIMITED,
        naive_fails: lattice::cancel_naive,
        robust_fails: lattice::cancel_robust,
    },
    Case {
        id: "X-08",
        chapter: CHAPTER,
        input: "everything 2^k times as large",
        most: UNLIMITED,
        naive_fails: same::scale_naive,
        robust_fails: same::scale_robust,
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

    /// Ten million rays each; `cargo test --release -p triangles -- --ignored` takes a minute or so.
    #[test]
    #[ignore = "takes a minute"]
    fn ten_million_rays_at_edges_and_vertices() {
        let aimed = |case: &&Case| ["TR-02", "TR-03", "TR-04", "TR-10"].contains(&case.id);
        let cases: Vec<Case> = CASES.iter().filter(aimed).copied().collect();
        let ledger = Ledger::of(&cases, 10_000_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }
}
