//! MI-01 to MI-04: weights of densities of any size.

use common::hard::Case;

use super::CHAPTER;
use crate::heuristic::Heuristic;
use crate::naive;

/// The powers of two from 2⁻¹²⁷ to 2¹²⁷.
const POWERS: u64 = 255;
/// Every third of them.
const THIRDS: u64 = POWERS / 3;

const RULES: [Heuristic; 2] = [Heuristic::Balance, Heuristic::Power];

type Weight = fn(own: f32, other: f32) -> f32;

/// 2 to the power of `index` - 127; infinity after the last.
fn power(index: u64) -> f32 {
    if index == POWERS { f32::INFINITY } else { libm::ldexpf(1.0, index as i32 - 127) }
}

/// Whether both weights don't add up to 1.
fn fail(one: f32, other: f32, weight: impl Fn(f32, f32) -> f32) -> bool {
    !((weight(one, other) + weight(other, one) - 1.0).abs() <= 1e-6)
}

fn any_fails(one: f32, other: f32) -> bool {
    RULES.iter().any(|rule| fail(one, other, |own, other| rule.weight(own, other)))
}

/// MI-01: all pairs of exponents.
pub(super) const SQUARES: Case = Case {
    id: "MI-01",
    chapter: CHAPTER,
    input: "two weights of the power heuristic, all pairs of exponents",
    most: POWERS * POWERS,
    naive_fails: |trial| {
        let [one, other] = pair(trial);
        fail(one, other, naive::power)
    },
    robust_fails: |trial| {
        let [one, other] = pair(trial);
        any_fails(one, other)
    },
};

fn pair(trial: u64) -> [f32; 2] {
    [power(trial / POWERS), power(trial % POWERS)]
}

/// MI-02: one density is 0, or both are.
pub(super) const ZEROS: Case = Case {
    id: "MI-02",
    chapter: CHAPTER,
    input: "a density of 0 against all exponents, and against 0",
    most: POWERS + 1,
    naive_fails: |trial| zero_fails(trial, naive::power),
    robust_fails: |trial| {
        zero_fails(trial, |own, other| Heuristic::Balance.weight(own, other))
            || zero_fails(trial, |own, other| Heuristic::Power.weight(own, other))
    },
};

fn zero_fails(trial: u64, weight: Weight) -> bool {
    if trial == POWERS {
        return weight(0.0, 0.0) != 0.0;
    }
    let other = power(trial);
    (weight(0.0, other), weight(other, 0.0)) != (0.0, 1.0)
}

/// MI-03: densities up to infinity, and the rule that an infinite square counts all.
pub(super) const LIMITS: Case = Case {
    id: "MI-03",
    chapter: CHAPTER,
    input: "the same up to infinity; naive: infinite squares weigh 1",
    most: (POWERS + 1) * (POWERS + 1),
    naive_fails: |trial| {
        let [one, other] = pair_with_limit(trial);
        fail(one, other, naive::infinite_is_one)
    },
    robust_fails: |trial| {
        let [one, other] = pair_with_limit(trial);
        any_fails(one, other)
    },
};

fn pair_with_limit(trial: u64) -> [f32; 2] {
    [power(trial / (POWERS + 1)), power(trial % (POWERS + 1))]
}

/// MI-04: three strategies, every third exponent.
pub(super) const MANY: Case = Case {
    id: "MI-04",
    chapter: CHAPTER,
    input: "three weights, all triples of every third exponent",
    most: THIRDS * THIRDS * THIRDS,
    naive_fails: |trial| {
        let squares = triple(trial).map(|density| density * density);
        let total: f32 = squares.iter().sum();
        let sum: f32 = squares.iter().map(|square| square / total).sum();
        !((sum - 1.0).abs() <= 1e-6)
    },
    robust_fails: |trial| {
        let densities = triple(trial);
        RULES.iter().any(|rule| {
            let sum: f32 = (0..3).map(|own| rule.among(&densities, own)).sum();
            !((sum - 1.0).abs() <= 1e-6)
        })
    },
};

fn triple(trial: u64) -> [f32; 3] {
    [trial / (THIRDS * THIRDS), trial / THIRDS % THIRDS, trial % THIRDS]
        .map(|index| power(3 * index + 1))
}
