//! Judges the five exercises of chapter 5, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use shadows::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_5_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "5.1",
        title: "A question of its own",
        section: "A question of its own",
        cases: cases::lines,
        expected: cases::Line::is_clear,
        agree: |_, expected, yours| expected == yours,
        yours: |case| exercises::sees(&case.spheres, case.point, case.lamp),
        solution: |case| solutions::sees(&case.spheres, case.point, case.lamp),
        mistakes: mistakes::of_sees(),
    }
    .judge()
}

#[test]
fn exercise_5_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "5.2",
        title: "Several lamps",
        section: "Several lamps",
        cases: cases::places,
        expected: cases::Place::light,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-5),
        yours: |case| {
            let (point, normal) = (case.point, case.normal);
            exercises::light_at(&case.spheres, &case.lamps(), case.ambient, point, normal)
        },
        solution: solutions::light_at,
        mistakes: mistakes::of_light_at(),
    }
    .judge()
}

#[test]
fn exercise_5_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "5.3",
        title: "Off the surface",
        section: "As far as the point may be wrong",
        cases: cases::leavings,
        expected: |_| 1.0,
        agree: |case, expected, yours| case.agree(*expected, *yours),
        yours: |case| case.clearance(exercises::leave(&case.hit, case.direction)),
        solution: |case| case.clearance(solutions::leave(&case.hit, case.direction)),
        mistakes: mistakes::of_leave(),
    }
    .judge()
}

#[test]
fn exercise_5_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "5.4",
        title: "Find the mistake: the report's test of visibility",
        section: "The report's line",
        cases: cases::rooms,
        expected: |room| room.is_lit,
        agree: |_, expected, yours| expected == yours,
        yours: |room| exercises::sees_lamp(&room.shapes(), &room.hit(), room.lamp()),
        solution: |room| solutions::sees_lamp(&room.shapes(), &room.hit(), room.lamp()),
        mistakes: mistakes::of_sees_lamp(),
    }
    .judge()
}

#[test]
fn exercise_5_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "5.5",
        title: "Not through the surface",
        section: "Two normals",
        cases: cases::sides,
        expected: cases::Sides::cosine,
        agree: |_, expected, yours| agree::within(*expected, *yours, 1e-5),
        yours: |&cases::Sides { geometric, shading, eye, lamp }| {
            exercises::arriving_cosine(geometric, shading, eye, lamp)
        },
        solution: solutions::arriving_cosine,
        mistakes: mistakes::of_arriving_cosine(),
    }
    .judge()
}
