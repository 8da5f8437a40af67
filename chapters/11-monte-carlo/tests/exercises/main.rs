//! Judges the five exercises of chapter 11, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use cases::{Choice, Feature, Patch, Sky};
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use monte_carlo::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

/// A right answer is refused once in 10⁶ cases; the seeds are fixed.
const SIGNIFICANCE: f64 = 1e-6;

#[test]
fn exercise_11_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "11.1",
        title: "A point of the disk",
        section: "Warps",
        cases: cases::features,
        expected: Feature::exact,
        agree: |_, expected, yours| expected.agrees(yours, SIGNIFICANCE),
        yours: |feature| feature.estimate(exercises::disk),
        solution: |feature| feature.estimate(solutions::disk),
        mistakes: mistakes::of_disk(),
    }
    .judge()
}

#[test]
fn exercise_11_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "11.2",
        title: "The light of a sky",
        section: "Choose where to look",
        cases: cases::skies,
        expected: Sky::exact,
        agree: |_, expected, yours| expected.agrees(yours, SIGNIFICANCE),
        yours: |sky| sky.estimate(exercises::irradiance),
        solution: |sky| sky.estimate(solutions::irradiance),
        mistakes: mistakes::of_irradiance(),
    }
    .judge()
}

#[test]
fn exercise_11_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "11.3",
        title: "A triangle",
        section: "Warps",
        cases: cases::patches,
        expected: Patch::exact,
        agree: |_, expected, yours| expected.agrees(yours, SIGNIFICANCE),
        yours: |patch| patch.estimate(exercises::over_triangle),
        solution: |patch| patch.estimate(solutions::over_triangle),
        mistakes: mistakes::of_over_triangle(),
    }
    .judge()
}

#[test]
fn exercise_11_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "11.4",
        title: "One of many",
        section: "One of many",
        cases: cases::choices,
        expected: Choice::exact,
        agree: |_, expected, yours| expected.agrees(yours, SIGNIFICANCE),
        yours: |choice| choice.estimate(exercises::one_of_many),
        solution: |choice| choice.estimate(solutions::one_of_many),
        mistakes: mistakes::of_one_of_many(),
    }
    .judge()
}

#[test]
fn exercise_11_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "11.5",
        title: "Find the mistake: the variance",
        section: "How far off",
        cases: cases::lists,
        expected: |samples| cases::variance(samples),
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-6),
        yours: |samples| exercises::variance(samples),
        solution: |samples| solutions::variance(samples),
        mistakes: mistakes::of_variance(),
    }
    .judge()
}
