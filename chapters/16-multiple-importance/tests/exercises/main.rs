//! Judges the five exercises of chapter 16, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use cases::{Arrival, Found, Pair, Point};
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use multiple_importance::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_16_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "16.1",
        title: "Shares",
        section: "Squares that are no numbers",
        cases: cases::pairs,
        expected: Pair::power,
        agree: |_, expected, yours| agree::within(*expected, *yours, 1e-5),
        yours: |&Pair { own, other }| exercises::power(own, other),
        solution: solutions::power,
        mistakes: mistakes::of_power(),
    }
    .judge()
}

#[test]
fn exercise_16_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "16.2",
        title: "One from each",
        section: "Shares that add up to one",
        cases: cases::sites,
        expected: |site| site.exact(1.2),
        agree: |_, expected, yours| Found::agree(expected, yours, 1.2),
        yours: |site| site.of_each(exercises::combined),
        solution: |site| site.of_each(solutions::combined),
        mistakes: mistakes::of_combined(),
    }
    .judge()
}

#[test]
fn exercise_16_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "16.3",
        title: "Come upon",
        section: "The path tracer",
        cases: cases::arrivals,
        expected: Arrival::share,
        agree: |_, expected, yours| agree::within(*expected, *yours, 1e-5),
        yours: |it| exercises::share(&it.departure, it.light_pdf),
        solution: solutions::share,
        mistakes: mistakes::of_share(),
    }
    .judge()
}

#[test]
fn exercise_16_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "16.4",
        title: "One of two",
        section: "Shares that add up to one",
        cases: cases::sites,
        expected: |site| site.exact(1.5),
        agree: |_, expected, yours| Found::agree(expected, yours, 1.5),
        yours: |site| site.of_one(exercises::one_of_two),
        solution: |site| site.of_one(solutions::one_of_two),
        mistakes: mistakes::of_one_of_two(),
    }
    .judge()
}

#[test]
fn exercise_16_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "16.5",
        title: "Find the mistake: a weight by area",
        section: "Apples and steradians",
        cases: cases::points,
        expected: Point::weight,
        agree: |_, expected, yours| agree::within(*expected, *yours, 1e-5),
        yours: |&Point { area, distance, cosine, by_direction }| {
            exercises::weight_by_area(area, distance, cosine, by_direction)
        },
        solution: solutions::weight_by_area,
        mistakes: mistakes::of_weight_by_area(),
    }
    .judge()
}
