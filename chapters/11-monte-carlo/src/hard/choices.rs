//! MC-07: choosing one of several, some of which must never be chosen.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;

use super::CHAPTER;
use crate::naive;
use crate::table::Table;

const THINGS: usize = 6;

/// MC-07: both ends of the numbers, and weights of 0 at both ends of the list.
pub(super) const ENDS: Case = Case {
    id: "MC-07",
    chapter: CHAPTER,
    input: "one of six by weight, some of which are 0, with the smallest and largest u",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (weights, u) = choice(trial);
        is_impossible(&weights, naive::pick(&weights, u))
    },
    robust_fails: |trial| {
        let (weights, u) = choice(trial);
        Table::new(&weights).is_none_or(|table| {
            let pick = table.pick(u);
            is_impossible(&weights, pick.index)
                || is_not_share(&weights, pick.index, pick.probability)
        })
    },
};

fn choice(trial: u64) -> ([f32; THINGS], f32) {
    let mut stream = Stream::of_trial(1110, trial);
    let mut weights: [f32; THINGS] = std::array::from_fn(|_| {
        let weight = stream.between(0.01, 10.0);
        if stream.bits().is_multiple_of(3) { 0.0 } else { weight }
    });
    // One of them can be chosen.
    weights[stream.bits() as usize % THINGS] = stream.between(0.01, 10.0);
    let u = stream.uniform();
    (weights, [0.0, 1.0f32.next_down(), u][trial as usize % 3])
}

fn is_impossible(weights: &[f32], index: usize) -> bool {
    weights.get(index).is_none_or(|&weight| weight == 0.0)
}

fn is_not_share(weights: &[f32], index: usize, probability: f32) -> bool {
    let total: f64 = weights.iter().map(|&weight| f64::from(weight)).sum();
    !((f64::from(probability) - f64::from(weights[index]) / total).abs() <= 1e-6)
}
