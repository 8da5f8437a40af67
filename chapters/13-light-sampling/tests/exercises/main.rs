//! Judges the six exercises of chapter 13, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use cases::{Arrival, Ball, Many, Scene, Spot, Weighed};
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use light_sampling::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_13_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "13.1",
        title: "From area to solid angle",
        section: "From directions to points",
        cases: cases::spots,
        expected: Spot::density,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-4),
        yours: |&Spot { distance, cosine, area }| exercises::density(distance, cosine, area),
        solution: |&Spot { distance, cosine, area }| solutions::density(distance, cosine, area),
        mistakes: mistakes::of_density(),
    }
    .judge()
}

#[test]
fn exercise_13_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "13.2",
        title: "A whole estimator",
        section: "A point of the lamp",
        cases: cases::scenes,
        expected: Scene::exact,
        // A right answer is refused once in 10⁶ cases; the seeds are fixed.
        agree: |_, expected, yours| expected.agrees(yours, 1e-6),
        yours: |scene| scene.estimate(exercises::direct),
        solution: |scene| scene.estimate(solutions::direct),
        mistakes: mistakes::of_direct(),
    }
    .judge()
}

#[test]
fn exercise_13_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "13.3",
        title: "A ball's cap",
        section: "A ball's cap",
        cases: cases::balls,
        expected: Ball::density,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-4),
        yours: |&Ball { distance, radius }| exercises::ball_density(distance, radius),
        solution: |&Ball { distance, radius }| solutions::ball_density(distance, radius),
        mistakes: mistakes::of_ball_density(),
    }
    .judge()
}

#[test]
fn exercise_13_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "13.4",
        title: "One of many",
        section: "One of many lamps",
        cases: cases::many,
        expected: Many::exact,
        agree: |_, expected, yours| expected.agrees(yours, 1e-6),
        yours: |many| many.estimate(exercises::one_lamp),
        solution: |many| many.estimate(solutions::one_lamp),
        mistakes: mistakes::of_one_lamp(),
    }
    .judge()
}

#[test]
fn exercise_13_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "13.5",
        title: "Once, and not twice",
        section: "Once, and not twice",
        cases: cases::arrivals,
        expected: Arrival::share,
        agree: |_, expected, yours| agree::within(*expected, *yours, 0.0),
        yours: |&Arrival { from_eye, from_mirror, is_chosen }| {
            exercises::share(from_eye, from_mirror, is_chosen)
        },
        solution: solutions::share,
        mistakes: mistakes::of_share(),
    }
    .judge()
}

#[test]
fn exercise_13_6() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "13.6",
        title: "Find the mistake: the report's line",
        section: "From directions to points",
        cases: cases::weighed,
        expected: Weighed::light,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-4),
        yours: |it| it.of(exercises::light),
        solution: |it| it.of(solutions::light),
        mistakes: mistakes::of_light(),
    }
    .judge()
}
