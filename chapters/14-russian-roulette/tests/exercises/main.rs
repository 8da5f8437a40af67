//! Judges the six exercises of chapter 14, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod picture;
mod solutions;

use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise};
use russian_roulette::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

/// How often a right answer may be taken for a wrong one. Seeds are fixed: a verdict never changes.
const SIGNIFICANCE: f64 = 1e-5;

#[test]
fn exercise_14_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "14.1",
        title: "Half as often, twice as much",
        section: "Equation 4-5",
        cases: cases::lights,
        expected: cases::Light::expected,
        agree: |_, expected, yours| expected.agrees(yours, SIGNIFICANCE),
        yours: |light| light.mean(exercises::estimate),
        solution: |light| light.mean(solutions::estimate),
        mistakes: mistakes::of_estimate(),
    }
    .judge()
}

#[test]
fn exercise_14_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "14.2",
        title: "A path without a depth",
        section: "A path without a depth",
        cases: cases::rooms,
        expected: cases::Room::expected,
        agree: |_, expected, yours| expected.agrees(yours, SIGNIFICANCE),
        yours: |room| room.mean(exercises::furnace),
        solution: |room| room.mean(solutions::furnace),
        mistakes: mistakes::of_furnace(),
    }
    .judge()
}

#[test]
fn exercise_14_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "14.3",
        title: "The price in noise",
        section: "The price in noise",
        cases: cases::rooms_and_worse,
        expected: cases::Room::variance,
        agree: |_, expected, yours| cases::alike(*expected, *yours),
        yours: |room| exercises::variance(room.albedo.into(), room.survival.into()),
        solution: |room| solutions::variance(room.albedo.into(), room.survival.into()),
        mistakes: mistakes::of_variance(),
    }
    .judge()
}

#[test]
fn exercise_14_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "14.4",
        title: "By what it carries",
        section: "By what a path carries",
        cases: cases::loads,
        expected: cases::Load::survival,
        agree: |_, expected, yours| cases::same(*expected, *yours),
        yours: |load| exercises::survival(load.throughput, load.threshold),
        solution: |load| solutions::survival(load.throughput, load.threshold),
        mistakes: mistakes::of_survival(),
    }
    .judge()
}

#[test]
fn exercise_14_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "14.5",
        title: "One decision for three colours",
        section: "By what a path carries",
        cases: cases::colored_rooms,
        expected: cases::ColoredRoom::expected,
        agree: |_, expected, yours| {
            expected.iter().zip(yours).all(|(expected, yours)| expected.agrees(yours, SIGNIFICANCE))
        },
        yours: |room| room.mean(exercises::colored),
        solution: |room| room.mean(solutions::colored),
        mistakes: mistakes::of_colored(),
    }
    .judge()
}

#[test]
fn exercise_14_6() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "14.6",
        title: "Find the mistake: the report's line",
        section: "The report's line",
        cases: picture::boxes,
        expected: picture::Picture::whole,
        agree: |_, expected, yours| picture::alike(expected, yours),
        yours: |it| it.draw(exercises::go_on),
        solution: |it| it.draw(solutions::go_on),
        mistakes: mistakes::of_go_on(),
    }
    .judge_picture()
}
