//! Judges the six exercises of chapter 1, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use ray_casting::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_1_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "1.1",
        title: "One ray for each pixel",
        section: "From a pixel to a ray",
        cases: cases::pixels,
        expected: cases::Pixel::direction,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-5),
        yours: |&cases::Pixel { x, y, width, height, vertical_fov, .. }| {
            exercises::pixel_direction(x, y, width, height, vertical_fov)
        },
        solution: solutions::pixel_direction,
        mistakes: mistakes::of_pixel_direction(),
    }
    .judge()
}

#[test]
fn exercise_1_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "1.2",
        title: "The quadratic",
        section: "Where a ray meets a sphere",
        cases: cases::spheres,
        expected: cases::Aim::distance,
        agree: |_, expected, yours| {
            agree::options(expected, yours, |expected, yours| agree::close(*expected, *yours, 1e-4))
        },
        yours: |case| exercises::hit_sphere(&case.sphere, &case.ray),
        solution: |case| solutions::hit_sphere(&case.sphere, &case.ray),
        mistakes: mistakes::of_hit_sphere(),
    }
    .judge()
}

#[test]
fn exercise_1_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "1.3",
        title: "What hides what",
        section: "The nearest hit",
        cases: cases::heaps,
        expected: |heap| heap.picture(cases::first_seen),
        agree: |_, expected, yours| agree::films(expected, yours, 0.0),
        yours: |heap| heap.picture(exercises::first_seen),
        solution: |heap| heap.picture(solutions::first_seen),
        mistakes: mistakes::of_first_seen(),
    }
    .judge_picture()
}

#[test]
fn exercise_1_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "1.4",
        title: "A new shape",
        section: "Planes and quads",
        cases: cases::disks,
        expected: cases::Disk::distance,
        agree: |_, expected, yours| {
            agree::options(expected, yours, |expected, yours| agree::close(*expected, *yours, 1e-4))
        },
        yours: |case| exercises::hit_disk(case.center, case.normal, case.radius, &case.ray),
        solution: solutions::hit_disk,
        mistakes: mistakes::of_hit_disk(),
    }
    .judge()
}

#[test]
fn exercise_1_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "1.5",
        title: "No digit lost",
        section: "Two roots, no subtraction",
        cases: cases::quadratics,
        expected: cases::Quadratic::roots,
        agree: |_, expected, yours| {
            agree::options(expected, yours, |expected, yours| {
                expected
                    .iter()
                    .zip(yours)
                    .all(|(&expected, &yours)| agree::close(expected, yours, 1e-6))
            })
        },
        yours: |case| exercises::roots(case.a, case.h, case.c),
        solution: solutions::roots,
        mistakes: mistakes::of_roots(),
    }
    .judge()
}

#[test]
fn exercise_1_6() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "1.6",
        title: "Find the mistake: the report's camera",
        section: "A camera anywhere",
        cases: cases::views,
        expected: cases::Seen::direction,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-5),
        yours: |&cases::Seen { position, size, scale, eye, target }| {
            exercises::look_at_direction(position, size, scale, eye, target)
        },
        solution: solutions::look_at_direction,
        mistakes: mistakes::of_look_at_direction(),
    }
    .judge()
}
