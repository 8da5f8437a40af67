//! The exercises of chapter 9, judged.

mod cases;
mod mistakes;
mod solutions;

use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use partitions::exercises::{cell_of, cells_along, expected_tests, middle, nearest};

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_9_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "9.1",
        title: "Which cell is it?",
        section: "Which cell is it?",
        cases: cases::coordinates,
        expected: cases::exact_cell,
        agree: |_, expected, yours| expected == yours,
        yours: |it| cell_of(it.coordinate, it.low, it.high, it.cells),
        solution: |it| solutions::cell_of(it.coordinate, it.low, it.high, it.cells),
        mistakes: mistakes::cell_of(),
    }
    .judge()
}

#[test]
fn exercise_9_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "9.2",
        title: "The way through a grid",
        section: "From cell to cell",
        cases: cases::lines,
        expected: cases::cells_by_middles,
        agree: |_, expected, yours| expected == yours,
        yours: |it| cells_along(it.origin, it.direction, it.cells),
        solution: |it| solutions::cells_along(it.origin, it.direction, it.cells),
        mistakes: mistakes::cells_along(),
    }
    .judge()
}

#[test]
fn exercise_9_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "9.3",
        title: "The first hit that is found",
        section: "The first hit that is found",
        cases: cases::ways,
        expected: |it| cases::least_of_all(it),
        agree: |_, expected, yours| expected == yours,
        yours: |it| nearest(it),
        solution: |it| solutions::nearest(it),
        mistakes: mistakes::nearest(),
    }
    .judge()
}

#[test]
fn exercise_9_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "9.4",
        title: "A plane in the middle",
        section: "Cut in eight",
        cases: cases::cells,
        expected: cases::middle_in_f64,
        agree: |case, expected, yours| {
            agree::options(expected, yours, |expected, yours| case.is_middle(*expected, *yours))
        },
        yours: |it| middle(it.low, it.high),
        solution: |it| solutions::middle(it.low, it.high),
        mistakes: mistakes::middle(),
    }
    .judge()
}

#[test]
fn exercise_9_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "9.5",
        title: "What a cut costs",
        section: "By surface area",
        cases: cases::cuts,
        expected: cases::by_faces,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-5),
        yours: |it| expected_tests(it.size, it.part, it.below, it.above),
        solution: |it| solutions::expected_tests(it.size, it.part, it.below, it.above),
        mistakes: mistakes::expected_tests(),
    }
    .judge()
}
