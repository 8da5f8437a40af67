//! MC-01 and MC-09: numbers that are rounded out of where they belong.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;

use super::CHAPTER;
use crate::{naive, sobol, strata};

/// MC-01: the largest random bits, one after the other from the top.
pub(super) const UNIT: Case = Case {
    id: "MC-01",
    chapter: CHAPTER,
    input: "the largest 32 random bits, as a number below 1",
    most: 1 << 32,
    naive_fails: |trial| is_outside(naive::unit(u32::MAX - trial as u32)),
    robust_fails: |trial| is_outside(sobol::unit(u32::MAX - trial as u32)),
};

fn is_outside(number: f32) -> bool {
    !(0.0..1.0).contains(&number)
}

/// MC-09: points of strata, a quarter of them at the upper end.
pub(super) const STRATUM: Case = Case {
    id: "MC-09",
    chapter: CHAPTER,
    input: "a point in one of 3, 10, 1000 or 2^24 strata",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (index, count, u) = stratum(trial);
        is_elsewhere(index, count, naive::place(index, count, u))
    },
    robust_fails: |trial| {
        let (index, count, u) = stratum(trial);
        let place = strata::place(index, count, u);
        is_elsewhere(index, count, place) || strata::number(place, count) != index
    },
};

fn stratum(trial: u64) -> (u32, u32, f32) {
    let mut stream = Stream::of_trial(1104, trial);
    let count = [3, 10, 1000, 1 << 24][trial as usize % 4];
    let index = if stream.bits().is_multiple_of(8) { count - 1 } else { stream.bits() % count };
    let u = stream.uniform();
    (index, count, if stream.bits().is_multiple_of(4) { 1.0f32.next_down() } else { u })
}

/// Whether x isn't in [i/n, (i + 1)/n), by integers: x is a multiple of 2⁻⁶⁰, but for numbers so
/// small that they are in the first stratum anyhow.
fn is_elsewhere(index: u32, count: u32, x: f32) -> bool {
    let whole = (f64::from(x) * f64::from(1 << 30) * f64::from(1 << 30)) as u128;
    (whole * u128::from(count)) >> 60 != u128::from(index)
}
