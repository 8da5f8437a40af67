//! The chapter's hard cases: rays on which a fixed epsilon fails and an offset by the error doesn't.
//!
//! A trial's number makes its input. What decides is known by construction (a flat triangle is not
//! hit by what leaves it), is `f64` arithmetic on the same `f32` input, or is the same question put
//! in another way.

pub(crate) mod ball;
mod corner;
pub(crate) mod draw;
pub(crate) mod grid;
mod integer;
mod lamp;
mod lattice;
#[cfg(feature = "native")]
mod picture;
mod scaling;
mod swapped;
mod terminator;

use common::hard::{Case, UNLIMITED};

#[cfg(feature = "native")]
pub use picture::picture;

/// This chapter, as the ledger names it.
const CHAPTER: &str = "05-shadows";

/// All of them, in the catalogue's order, and last the two ends of a line of sight.
pub const CASES: &[Case] = &[
    case(
        "SH-01",
        "triangles 10^-4 to 10^4 large, to 10^6 away: self-hits",
        [grid::hits_itself_naive, grid::hits_itself_robust],
    ),
    case(
        "SH-02",
        "the same with a lid 64 floats above: leaks",
        [grid::leaks_naive, grid::leaks_robust],
    ),
    case("SH-03", "out of spheres and into them, from 10^8 away", [ball::naive, ball::robust]),
    case("SH-04", "a lid right before the lamp, or a lamp on a wall", [lamp::naive, lamp::robust]),
    case(
        "SH-05",
        "points from 2^-60 to 2^100, and 2^k as large",
        [integer::naive, integer::robust],
    ),
    case("SH-06", "close to a corner that is close to the origin", [corner::naive, corner::robust]),
    case("SH-07", "the whole scene times 2^k: the same answer?", [scaling::naive, scaling::robust]),
    case("SH-08", "the whole scene moved by up to 2^18", [lattice::naive, lattice::robust]),
    case(
        "SH-09",
        "tilted normals, a lamp behind the surface",
        [terminator::naive, terminator::robust],
    ),
    case("SH-10", "past a ball's rim: the same from both ends?", [swapped::naive, swapped::robust]),
];

const fn case(id: &'static str, input: &'static str, fails: [fn(u64) -> bool; 2]) -> Case {
    let [naive_fails, robust_fails] = fails;
    Case { id, chapter: CHAPTER, input, most: UNLIMITED, naive_fails, robust_fails }
}

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    fn check(trials: u64) {
        let ledger = Ledger::of(CASES, trials);
        assert!(ledger.broken().is_empty(), "\n{ledger}");
    }

    #[test]
    fn the_robust_formulas_hold_and_the_controls_fail() {
        check(50_000);
    }

    #[test]
    #[ignore = "takes minutes: cargo test --release -p shadows -- --ignored"]
    fn not_once_in_ten_million() {
        check(10_000_000);
    }
}
