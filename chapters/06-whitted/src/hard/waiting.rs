//! WH-14: how many branches wait while others are followed.

use common::hard::Case;
use common::math;
use common::sampler::Stream;
use common::tally::Counts;

use super::CHAPTER;
use crate::iteration::MOST_WAITING;
use crate::limits::Limits;
use crate::naive;
use crate::tree::Tree;

/// WH-14: two branches at each surface, and no end but the cut-off.
pub(super) const WAITING: Case = Case {
    id: "WH-14",
    chapter: CHAPTER,
    input: "two branches at each surface: more than log2(3 / cut-off) of them wait",
    most: 1000,
    naive_fails: |trial| {
        let (tree, limits) = tree(trial);
        is_too_long(naive::most_waiting_in_order(&limits, &tree, Tree::ROOT), &limits)
    },
    robust_fails: |trial| {
        let (tree, limits) = tree(trial);
        let mut counts = Counts::default();
        limits.trace(&tree, Tree::ROOT, &mut counts);
        is_too_long(counts.of(MOST_WAITING), &limits)
    },
};

fn tree(trial: u64) -> (Tree, Limits) {
    let mut stream = Stream::of_trial(614, trial);
    let cutoff = math::pow(10.0, stream.between(-3.0, -0.5));
    (Tree { seed: trial, branches: 2 }, Limits { depth: u32::MAX, cutoff })
}

/// Whether 2^most is above 3 / cutoff.
fn is_too_long(most: u64, limits: &Limits) -> bool {
    let halvings = 3.0 / f64::from(limits.cutoff);
    most >= 64 || (1u64 << most) as f64 > halvings
}
