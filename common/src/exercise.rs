//! Exercises that say what went wrong.
//!
//! A reader fills in a stub in the chapter's `src/exercises.rs`. One test judges it, and proves
//! each time that its verdict can be trusted: the solution passes, and every known mistake is
//! rejected *and recognised by its own name* ([`Exercise::prove`]). Only then is the reader's code
//! asked. An untouched stub is "not started", and the test passes; all else passes, or fails with
//! the diagnosis, the first differing case, what was expected and what came.
//!
//! # How an exercise looks
//!
//! The stub, in `src/exercises.rs`. The `let _` keeps the compiler quiet about unused arguments
//! until the reader replaces both lines; the message of `todo!` is the exercise's number, as here:
//!
//! ```
//! pub fn discriminant(a: f32, b: f32, c: f32) -> f32 {
//!     let _ = (a, b, c);
//!     todo!("exercise 1.2")
//! }
//! ```
//!
//! The test, in `tests/exercises/main.rs`; solutions and mistakes have files beside it:
//!
//! ```no_run
//! use common::exercise::judge::Failure;
//! use common::exercise::{Chapter, Exercise, Mistake, agree};
//!
//! const CHAPTER: Chapter =
//!     Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };
//!
//! #[derive(Debug)]
//! struct Quadratic { a: f32, b: f32, c: f32 }
//!
//! # fn discriminant(a: f32, b: f32, c: f32) -> f32 { b * b - 4.0 * a * c }
//! # /*
//! #[test]
//! # */
//! fn exercise_1_2() -> Result<(), Failure> {
//!     Exercise {
//!         chapter: CHAPTER,
//!         number: "1.2",
//!         title: "Hit or miss",
//!         section: "The discriminant",
//!         cases: || vec![Quadratic { a: 1.0, b: 3.0, c: 2.0 }, Quadratic { a: 2.0, b: 1.0, c: 5.0 }],
//!         expected: |case| {
//!             let (a, b, c) = (f64::from(case.a), f64::from(case.b), f64::from(case.c));
//!             (b * b - 4.0 * a * c) as f32
//!         },
//!         agree: |_, expected, yours| agree::close(*expected, *yours, 1e-6),
//!         yours: |case| discriminant(case.a, case.b, case.c),
//!         solution: |case| case.b * case.b - 4.0 * case.a * case.c,
//!         mistakes: vec![
//!             Mistake {
//!                 name: "the factor 4 is missing",
//!                 diagnosis: "You took b² - ac. That is right only when b stands for half of it.",
//!                 answer: |case| case.b * case.b - case.a * case.c,
//!             },
//!             // and at least two more
//!         ],
//!     }
//!     .judge()
//! }
//! ```
//!
//! `judge_picture` is `judge` for answers that are a [`Film`](crate::film::Film): it also writes
//! the comparison page. For a random answer, let it be a [`stats::estimate::Estimate`] and agree by
//! [`Estimate::agrees`]; seeds are fixed, so a verdict never changes by itself.
//!
//! [`stats::estimate::Estimate`]: crate::stats::estimate::Estimate
//! [`Estimate::agrees`]: crate::stats::estimate::Estimate::agrees

pub mod agree;
pub mod diagnosis;
pub mod flaw;
pub mod outcome;
pub mod proof;
pub mod verdict;

#[cfg(test)]
mod example;
#[cfg(feature = "native")]
pub mod judge;
#[cfg(feature = "native")]
mod picture;
#[cfg(feature = "native")]
mod place;
#[cfg(feature = "native")]
pub mod record;

use std::fmt::Debug;

use outcome::Outcome;

/// Where a chapter is: both fields come from cargo, as in the example above.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// Its package, such as "ray-casting": `env!("CARGO_PKG_NAME")`.
    pub package: &'static str,
    /// Its folder: `env!("CARGO_MANIFEST_DIR")`.
    pub folder: &'static str,
}

/// An exercise: what it asks, on which inputs, and how its answers are judged.
///
/// All functions are plain `fn` pointers, so solutions and mistakes can be named in files of their
/// own; a closure that captures nothing is one too.
#[derive(Debug)]
pub struct Exercise<Case, Answer> {
    /// The chapter it belongs to.
    pub chapter: Chapter,
    /// "1.2": the second exercise of chapter 1. The stub is `todo!("exercise 1.2")`.
    pub number: &'static str,
    /// A few words.
    pub title: &'static str,
    /// The section of the chapter's page to read again.
    pub section: &'static str,
    /// Makes the inputs; the same ones each time. Simple ones first: the first case that differs
    /// is the one the reader sees.
    pub cases: fn() -> Vec<Case>,
    /// The right answer, from an independent oracle: a closed form or `f64`, not the solution.
    pub expected: fn(&Case) -> Answer,
    /// Whether an answer (third) is as good as another (second). NaN should agree with NaN, or a
    /// mistake that gives NaN is not recognised; [`agree`] has functions for this.
    pub agree: fn(&Case, &Answer, &Answer) -> bool,
    /// Calls the reader's code.
    pub yours: fn(&Case) -> Answer,
    /// Calls the solution.
    pub solution: fn(&Case) -> Answer,
    /// What readers get wrong: three or more, each unlike the others on some case.
    pub mistakes: Vec<Mistake<Case, Answer>>,
}

/// A wrong answer that somebody gave, or will.
#[derive(Debug)]
pub struct Mistake<Case, Answer> {
    /// A few words that no other mistake of the exercise has.
    pub name: &'static str,
    /// What the reader did, why it is wrong, and where to look: whole sentences, addressed to them.
    pub diagnosis: &'static str,
    /// The wrong code itself.
    pub answer: fn(&Case) -> Answer,
}

impl<Case: Debug, Answer: Debug> Exercise<Case, Answer> {
    /// Whether two outcomes are the same: answers that agree, or a panic each.
    fn same(&self, case: &Case, first: &Outcome<Answer>, second: &Outcome<Answer>) -> bool {
        match (first, second) {
            (Outcome::Answered(first), Outcome::Answered(second)) => {
                (self.agree)(case, first, second)
            }
            (Outcome::Panicked(_), Outcome::Panicked(_)) => true,
            _ => false,
        }
    }
}
