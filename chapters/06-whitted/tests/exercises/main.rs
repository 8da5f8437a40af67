//! Judges the six exercises of chapter 6, and proves each time that its judgment can be trusted.

mod balls;
mod cases;
mod forest;
mod mistakes;
mod solutions;

use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use whitted::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_6_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "6.1",
        title: "A mirror",
        section: "Which way a mirror sends light",
        cases: cases::turns,
        expected: cases::Turn::mirrored,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-5),
        yours: |case| exercises::mirror_direction(case.incoming, case.normal),
        solution: |case| solutions::mirror_direction(case.incoming, case.normal),
        mistakes: mistakes::of_mirror_direction(),
    }
    .judge()
}

#[test]
fn exercise_6_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "6.2",
        title: "Depth and cut-off",
        section: "Where following ends",
        cases: cases::ways,
        expected: cases::Way::radiance,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-5),
        yours: |case| exercises::along(&case.surfaces, case.depth, case.cutoff),
        solution: |case| solutions::along(&case.surfaces, case.depth, case.cutoff),
        mistakes: mistakes::of_along(),
    }
    .judge()
}

#[test]
fn exercise_6_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "6.3",
        title: "A picture with mirrors",
        section: "A surface's own light, and the mirror's",
        cases: balls::heaps,
        expected: balls::Heap::expected,
        agree: |_, expected, yours| balls::alike(expected, yours),
        yours: |heap| heap.picture(exercises::among),
        solution: |heap| heap.picture(solutions::among),
        mistakes: mistakes::of_among(),
    }
    .judge_picture()
}

#[test]
fn exercise_6_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "6.4",
        title: "A list in place of the stack",
        section: "The same as a loop",
        cases: forest::forests,
        expected: forest::Forest::total,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-9),
        yours: |forest| forest.asked(exercises::total),
        solution: |forest| forest.asked(solutions::total),
        mistakes: mistakes::of_total(),
    }
    .judge()
}

#[test]
fn exercise_6_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "6.5",
        title: "How deep is deep enough",
        section: "A series",
        cases: cases::mirrors,
        expected: cases::Mirrors::depth,
        agree: |_, expected, yours| expected == yours,
        yours: |case| exercises::depth_needed(case.mirror, case.missing),
        solution: |case| solutions::depth_needed(case.mirror, case.missing),
        mistakes: mistakes::of_depth_needed(),
    }
    .judge()
}

#[test]
fn exercise_6_6() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "6.6",
        title: "Find the mistake: the wrong side of the mirror",
        section: "Where the ray starts",
        cases: cases::starts,
        expected: cases::Start::origin,
        agree: |case, expected, yours| {
            agree::close_vectors(*expected - case.point, *yours - case.point, 1e-3)
        },
        yours: |case| {
            exercises::mirror_origin(case.point, case.normal, case.direction, case.epsilon)
        },
        solution: |case| {
            solutions::mirror_origin(case.point, case.normal, case.direction, case.epsilon)
        },
        mistakes: mistakes::of_mirror_origin(),
    }
    .judge()
}
