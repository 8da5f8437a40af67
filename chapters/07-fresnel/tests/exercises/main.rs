//! Judges the six exercises of chapter 7, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use cases::{Bend, Pair, Seen, Surface};
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use fresnel::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_7_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "7.1",
        title: "Snell's law",
        section: "Bending light",
        cases: cases::surfaces,
        expected: Surface::far_cosine,
        agree: |_, expected, yours| {
            agree::options(expected, yours, |expected, yours| {
                agree::within(*expected, *yours, 1e-4)
            })
        },
        yours: |&Surface { near, far, cosine }| exercises::far_cosine(near, far, cosine),
        solution: solutions::far_cosine,
        mistakes: mistakes::of_far_cosine(),
    }
    .judge()
}

#[test]
fn exercise_7_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "7.2",
        title: "In and out",
        section: "Bending light",
        cases: cases::bends,
        expected: Bend::direction,
        agree: |_, expected, yours| {
            agree::options(expected, yours, |expected, yours| {
                agree::close_vectors(*expected, *yours, 1e-4)
            })
        },
        yours: |&Bend { incoming, outward, index }| exercises::refract(incoming, outward, index),
        solution: solutions::refract,
        mistakes: mistakes::of_refract(),
    }
    .judge()
}

#[test]
fn exercise_7_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "7.3",
        title: "Fresnel's equations",
        section: "How much is reflected",
        cases: cases::surfaces,
        expected: Surface::reflectance,
        agree: |_, expected, yours| agree::within(*expected, *yours, 1e-4),
        yours: |&Surface { near, far, cosine }| exercises::reflectance(near, far, cosine),
        solution: solutions::reflectance,
        mistakes: mistakes::of_reflectance(),
    }
    .judge()
}

#[test]
fn exercise_7_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "7.4",
        title: "Schlick's approximation",
        section: "Schlick's approximation",
        cases: cases::surfaces,
        expected: Surface::schlick,
        agree: |_, expected, yours| agree::within(*expected, *yours, 1e-4),
        yours: |&Surface { near, far, cosine }| exercises::schlick(near, far, cosine),
        solution: solutions::schlick,
        mistakes: mistakes::of_schlick(),
    }
    .judge()
}

#[test]
fn exercise_7_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "7.5",
        title: "One of two",
        section: "Two rays, or one",
        cases: cases::pairs,
        expected: Pair::exact,
        // A right answer is refused once in 10⁶ cases; the seeds are fixed.
        agree: |_, expected, yours| expected.agrees(yours, 1e-6),
        yours: |pair| pair.estimate(exercises::one_of_two),
        solution: |pair| pair.estimate(solutions::one_of_two),
        mistakes: mistakes::of_one_of_two(),
    }
    .judge()
}

#[test]
fn exercise_7_6() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "7.6",
        title: "Find the mistake: equation 2-2",
        section: "Radiance in glass",
        cases: cases::seens,
        expected: Seen::radiance,
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-4),
        yours: |seen| {
            let &Seen { surface: Surface { near, far, cosine }, mirrored, refracted } = seen;
            exercises::seen(near, far, cosine, mirrored, refracted)
        },
        solution: solutions::seen,
        mistakes: mistakes::of_seen(),
    }
    .judge()
}
