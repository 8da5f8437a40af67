//! Judges the five exercises of chapter 4, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use blinn_phong::exercises;
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_4_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "4.1",
        title: "Lambert's law",
        section: "Lambert's law",
        cases: cases::matte,
        expected: cases::Matte::returned,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-5),
        yours: |case| exercises::lambert(case.diffuse, case.normal, case.toward_light, case.color),
        solution: solutions::lambert,
        mistakes: mistakes::of_lambert(),
    }
    .judge()
}

#[test]
fn exercise_4_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "4.2",
        title: "Two highlights",
        section: "Phong's highlight",
        cases: cases::shiny,
        expected: cases::Shiny::highlights,
        agree: |_, expected, yours| {
            let pairs = expected.iter().zip(yours);
            pairs.into_iter().all(|(&expected, &yours)| agree::within(expected, yours, 2e-5))
        },
        yours: |case| {
            let shininess = case.shininess as f32;
            exercises::highlights(case.normal, case.toward_eye, case.toward_light, shininess)
        },
        solution: solutions::highlights,
        mistakes: mistakes::of_highlights(),
    }
    .judge()
}

#[test]
fn exercise_4_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "4.3",
        title: "A lamp you can stand under",
        section: "Lamps",
        cases: cases::lamps,
        expected: cases::Lamp::arriving,
        agree: |_, expected, yours| {
            agree::options(expected, yours, |expected, yours| {
                agree::close_vectors(expected.0, yours.0, 1e-5)
                    && agree::close_vectors(expected.1, yours.1, 1e-5)
            })
        },
        yours: |case| exercises::arriving(case.position, case.color, case.point),
        solution: solutions::arriving,
        mistakes: mistakes::of_arriving(),
    }
    .judge()
}

#[test]
fn exercise_4_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "4.4",
        title: "A paint of your own",
        section: "Paint",
        cases: cases::places,
        expected: cases::Place::color,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 0.0),
        yours: |case| exercises::stripes(case.count, cases::COLORS, case.uv()),
        solution: solutions::stripes,
        mistakes: mistakes::of_stripes(),
    }
    .judge()
}

#[test]
fn exercise_4_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "4.5",
        title: "Find the mistake: equation 2-1",
        section: "Equation 2-1",
        cases: cases::points,
        expected: cases::Lit::radiance,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-4),
        yours: |case| {
            let material = case.material.plain();
            exercises::shade(&material, &case.lights, case.point, case.normal, case.eye)
        },
        solution: solutions::shade,
        mistakes: mistakes::of_shade(),
    }
    .judge()
}
