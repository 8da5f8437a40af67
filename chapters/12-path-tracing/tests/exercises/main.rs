//! Judges the five exercises of chapter 12, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use cases::{Depth, Ray, Room, Trip, Weight};
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use path_tracing::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_12_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "12.1",
        title: "What a direction counts",
        section: "One path",
        cases: cases::weights,
        expected: Weight::exact,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-5),
        yours: |&Weight { reflectance, cosine, pdf }| exercises::weight(reflectance, cosine, pdf),
        solution: solutions::weight,
        mistakes: mistakes::of_weight(),
    }
    .judge()
}

#[test]
fn exercise_12_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "12.2",
        title: "In the furnace",
        section: "The furnace",
        cases: cases::rooms,
        expected: Room::exact,
        agree: |_, expected, yours| cases::agree(expected, yours),
        yours: |room| room.estimate(exercises::furnace),
        solution: |room| room.estimate(solutions::furnace),
        mistakes: mistakes::of_furnace(),
    }
    .judge()
}

#[test]
fn exercise_12_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "12.3",
        title: "A whole path tracer",
        section: "The loop",
        cases: cases::trips,
        expected: Trip::exact,
        agree: |_, expected, yours| cases::agree(expected, yours),
        yours: |trip| trip.estimate(exercises::tiny_path),
        solution: |trip| trip.estimate(solutions::tiny_path),
        mistakes: mistakes::of_tiny_path(),
    }
    .judge()
}

#[test]
fn exercise_12_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "12.4",
        title: "Find the mistake: a question too early",
        section: "The loop",
        cases: cases::rays,
        expected: Ray::radiance,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-6),
        yours: |Ray { met, things, sky }| exercises::camera_light(met, things, *sky),
        solution: solutions::camera_light,
        mistakes: mistakes::of_camera_light(),
    }
    .judge()
}

#[test]
fn exercise_12_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "12.5",
        title: "How deep",
        section: "Where to stop",
        cases: cases::depths,
        expected: Depth::smallest,
        agree: |_, expected, yours| expected == yours,
        yours: |&Depth { albedo, missing }| exercises::depth(albedo, missing),
        solution: solutions::depth,
        mistakes: mistakes::of_depth(),
    }
    .judge()
}
