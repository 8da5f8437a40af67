//! A small exercise the machinery is tested with.

use super::{Chapter, Exercise, Mistake, agree};

#[derive(Debug)]
pub(super) struct Case {
    pub(super) a: f32,
    pub(super) b: f32,
    pub(super) c: f32,
}

pub(super) fn discriminant(case: &Case) -> f32 {
    case.b * case.b - 4.0 * case.a * case.c
}

pub(super) fn forgot_four(case: &Case) -> f32 {
    case.b * case.b - case.a * case.c
}

pub(super) fn forgot_square(case: &Case) -> f32 {
    case.b - 4.0 * case.a * case.c
}

pub(super) fn negated(case: &Case) -> f32 {
    4.0 * case.a * case.c - case.b * case.b
}

pub(super) fn exercise(yours: fn(&Case) -> f32) -> Exercise<Case, f32> {
    Exercise {
        chapter: Chapter { package: "common", folder: env!("CARGO_MANIFEST_DIR") },
        number: "1.2",
        title: "Hit or miss",
        section: "The discriminant",
        cases: || {
            [(1.0, 3.0, 2.0), (2.0, 1.0, 5.0), (3.0, 1.0, 2.0), (1.0, -4.0, -1.5)]
                .map(|(a, b, c)| Case { a, b, c })
                .into()
        },
        expected: |case| {
            let [a, b, c] = [case.a, case.b, case.c].map(f64::from);
            (b * b - 4.0 * a * c) as f32
        },
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-6),
        yours,
        solution: discriminant,
        mistakes: vec![
            Mistake {
                name: "the factor 4 is missing",
                diagnosis: "You took b² - ac. That is right only when b stands for half of it.",
                answer: forgot_four,
            },
            Mistake {
                name: "b is not squared",
                diagnosis: "You took b - 4ac: b is squared in the quadratic formula.",
                answer: forgot_square,
            },
            Mistake {
                name: "the sign is turned around",
                diagnosis: "You took 4ac - b², so hits and misses change places.",
                answer: negated,
            },
        ],
    }
}
