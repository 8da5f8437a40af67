//! Judges the five exercises of chapter 15, and proves each time that its judgment can be trusted.

mod cases;
mod mistakes;
mod solutions;

use cases::{Facet, Pair, Sky, Turn, View};
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use microfacets::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

#[test]
fn exercise_15_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "15.1",
        title: "The distribution",
        section: "How facets lie",
        cases: cases::facets,
        expected: Facet::density,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-5),
        yours: |&Facet { alpha, normal }| exercises::density(alpha, normal),
        solution: solutions::density,
        mistakes: mistakes::of_density(),
    }
    .judge()
}

#[test]
fn exercise_15_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "15.2",
        title: "Seen and lit",
        section: "Facets that are hidden",
        cases: cases::pairs,
        expected: Pair::both,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-4),
        yours: |&Pair { alpha, outgoing, incoming }| {
            exercises::seen_and_lit(alpha, outgoing, incoming)
        },
        solution: solutions::seen_and_lit,
        mistakes: mistakes::of_seen_and_lit(),
    }
    .judge()
}

#[test]
fn exercise_15_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "15.3",
        title: "What is seen",
        section: "Facets that are seen",
        cases: cases::views,
        expected: View::means,
        // A right answer is refused three times in 10⁶ cases; the seeds are fixed.
        agree: |_, expected, yours| expected.agree(yours, 1e-6),
        yours: |view| view.estimate(exercises::visible_normal),
        solution: |view| view.estimate(solutions::visible_normal),
        mistakes: mistakes::of_visible_normal(),
    }
    .judge()
}

#[test]
fn exercise_15_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "15.4",
        title: "A whole estimator",
        section: "The light that is lost",
        cases: cases::skies,
        expected: Sky::exact,
        agree: |_, expected, yours| expected.agrees(yours, 1e-6),
        yours: |sky| sky.estimate(exercises::sent_back),
        solution: |sky| sky.estimate(solutions::sent_back),
        mistakes: mistakes::of_sent_back(),
    }
    .judge()
}

#[test]
fn exercise_15_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "15.5",
        title: "Find the mistake: a density of directions",
        section: "From normals to directions",
        cases: cases::turns,
        expected: Turn::density,
        agree: |_, expected, yours| agree::close(*expected, *yours, 0.01),
        yours: |&Turn { outgoing, normal, density }| {
            exercises::reflected_density(outgoing, normal, density)
        },
        solution: solutions::reflected_density,
        mistakes: mistakes::of_reflected_density(),
    }
    .judge()
}
