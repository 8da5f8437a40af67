//! The chapter's hard cases: inputs on which published slab tests fail and ours doesn't.
//!
//! Each trial makes its input from its number. What decides is `f64` from the same inputs, a table of
//! answers known beforehand, chapter 2's own test, or the same question put in another way.

pub(crate) mod aimed;
pub(crate) mod draw;
pub(crate) mod in_plane;
mod nothing;
mod picture;
mod scaled;
mod shapes;

use common::hard::{Case, UNLIMITED};

use crate::naive::{glam_vectors, ize, tavian_2022};

pub use picture::picture;

const CHAPTER: &str = "08-boxes";

/// A case with this many trials at most.
const fn case(
    id: &'static str,
    input: &'static str,
    most: u64,
    naive_fails: fn(u64) -> bool,
    robust_fails: fn(u64) -> bool,
) -> Case {
    Case { id, chapter: CHAPTER, input, most, naive_fails, robust_fails }
}

/// All of them, in the order of the catalogue.
pub const CASES: &[Case] = &[
    case(
        "BX-01",
        "rays in the plane of a face, and beside it",
        in_plane::TABLE,
        in_plane::naive,
        in_plane::robust,
    ),
    case(
        "BX-02",
        "directions with a zero of either sign",
        UNLIMITED,
        in_plane::zero_naive,
        in_plane::zero_robust,
    ),
    case(
        "BX-03",
        "at corners and edges of closed meshes",
        UNLIMITED,
        |trial| aimed::anywhere(trial).is_lost_by(tavian_2022),
        |trial| aimed::anywhere(trial).is_lost(),
    ),
    case(
        "BX-03a",
        "at long edges from close by; naive: Ize's factor",
        UNLIMITED,
        |trial| aimed::room(trial).is_lost_by(ize),
        |trial| aimed::room(trial).is_lost(),
    ),
    case(
        "BX-03b",
        "at a mesh 10^3 to 10^5 from the origin",
        UNLIMITED,
        |trial| aimed::far_away(trial).is_lost_by(tavian_2022),
        |trial| aimed::far_away(trial).is_lost(),
    ),
    case(
        "BX-03c",
        "along an axis, whole coordinates",
        UNLIMITED,
        |trial| aimed::lattice(trial).is_lost_by(glam_vectors),
        |trial| aimed::lattice(trial).is_lost(),
    ),
    case(
        "BX-03d",
        "at slivers",
        UNLIMITED,
        |trial| aimed::sliver(trial).is_lost_by(tavian_2022),
        |trial| aimed::sliver(trial).is_lost(),
    ),
    case("BX-04", "boxes without thickness", UNLIMITED, shapes::flat_naive, shapes::flat_robust),
    case(
        "BX-05",
        "boxes of 10^15, rays all but along an axis",
        UNLIMITED,
        shapes::huge_naive,
        shapes::huge_robust,
    ),
    case(
        "BX-06",
        "origins in and on the box, rays that end at it",
        shapes::ENDS_COUNT,
        shapes::end_naive,
        shapes::end_robust,
    ),
    case(
        "BX-07",
        "boxes of points with NaN and infinity among them",
        UNLIMITED,
        nothing::naive,
        nothing::robust,
    ),
    case(
        "BX-08",
        "directions of 10^-45 to 10^3",
        UNLIMITED,
        shapes::tiny_naive,
        shapes::tiny_robust,
    ),
    case(
        "X-01",
        "NaN in one of two boxes that are joined",
        nothing::ORDERS,
        nothing::order_naive,
        nothing::order_robust,
    ),
    case(
        "X-08",
        "the whole scene times 2^k, k from -20 to 20",
        UNLIMITED,
        scaled::naive,
        scaled::robust,
    ),
];

#[cfg(test)]
mod tests {
    use common::hard::{Case, Ledger};

    use super::CASES;

    #[test]
    fn the_robust_test_holds_and_the_controls_fail() {
        let ledger = Ledger::of(CASES, 50_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }

    /// Ten million rays of each kind: `cargo test --release -p boxes -- --ignored`.
    #[test]
    #[ignore = "takes a minute or two"]
    fn not_one_of_ten_million_hits_is_lost() {
        let aimed = |case: &&Case| case.id.starts_with("BX-03");
        let cases: Vec<Case> = CASES.iter().filter(aimed).copied().collect();
        let ledger = Ledger::of(&cases, 10_000_000);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }
}
