//! The proof that an exercise can tell right from wrong, and the verdict that rests on it.

use std::fmt::Debug;

use super::Exercise;
use super::diagnosis::{debug, unrecognised, untouched};
use super::flaw::Flaw;
use super::outcome::{Outcome, attempt};
use super::verdict::{Difference, Status, Verdict};

/// An exercise that was proven: its solution passes, and each mistake is recognised by its name.
#[derive(Debug)]
pub struct Proven<Case, Answer> {
    pub(super) exercise: Exercise<Case, Answer>,
    pub(super) cases: Vec<Case>,
    pub(super) expected: Vec<Outcome<Answer>>,
    /// The answers of each mistake.
    pub(super) mistaken: Vec<Vec<Outcome<Answer>>>,
    words: fn(&Answer) -> String,
}

impl<Case: Debug, Answer: Debug> Exercise<Case, Answer> {
    /// Tries the oracle, the solution and all mistakes. `words` shows an answer to the reader; it is
    /// [`debug`] unless answers are long.
    ///
    /// # Errors
    ///
    /// All flaws that were found.
    pub fn prove(self, words: fn(&Answer) -> String) -> Result<Proven<Case, Answer>, Vec<Flaw>> {
        let cases = (self.cases)();
        let answers = |answer: fn(&Case) -> Answer| -> Vec<Outcome<Answer>> {
            cases.iter().map(|case| attempt(answer, case)).collect()
        };
        let (expected, solution) = (answers(self.expected), answers(self.solution));
        let mistaken = self.mistakes.iter().map(|mistake| answers(mistake.answer)).collect();
        let proven = Proven { exercise: self, cases, expected, mistaken, words };

        let flaws = proven.flaws(&solution);
        if flaws.is_empty() { Ok(proven) } else { Err(flaws) }
    }
}

impl<Case: Debug, Answer: Debug> Proven<Case, Answer> {
    /// The verdict on a reader's outcomes, one for each case in order. Missing ones are wrong.
    pub fn verdict(&self, yours: &[Outcome<Answer>]) -> Verdict {
        let count = self.cases.len();
        if let Some(number) = untouched(yours) {
            let first = format!("This one needs exercise {number}: do that first.");
            return Verdict::not_started(count, (number != self.exercise.number).then_some(first));
        }
        let differing: Vec<usize> =
            (0..count).filter(|&index| !self.same(index, &self.expected, yours)).collect();
        let Some(&first) = differing.first() else { return Verdict::done(count) };

        let recognised = self.mistaken.iter().position(|answers| self.all_same(answers, yours));
        let mistake = recognised.map(|index| &self.exercise.mistakes[index]);
        let diagnosis = match mistake {
            Some(mistake) => mistake.diagnosis.to_string(),
            None => unrecognised(yours.get(first)),
        };
        Verdict {
            status: Status::Wrong,
            mistake: mistake.map(|mistake| mistake.name),
            diagnosis: Some(diagnosis),
            differing: differing.len(),
            cases: count,
            first: Some(self.difference(first, yours.get(first))),
        }
    }

    /// The exercise itself.
    pub fn exercise(&self) -> &Exercise<Case, Answer> {
        &self.exercise
    }

    /// What the oracle said, for each case in order.
    pub fn expected(&self) -> &[Outcome<Answer>] {
        &self.expected
    }

    fn difference(&self, index: usize, yours: Option<&Outcome<Answer>>) -> Difference {
        Difference {
            index,
            case: debug(&self.cases[index]),
            expected: self.show(&self.expected[index]),
            yours: yours.map_or_else(|| "no answer".to_string(), |yours| self.show(yours)),
        }
    }

    pub(super) fn show(&self, outcome: &Outcome<Answer>) -> String {
        match outcome {
            Outcome::Answered(answer) => (self.words)(answer),
            Outcome::Panicked(panic) => format!("a panic: {}", panic.message),
            Outcome::Late(limit) => format!("no answer in {} s", limit.as_secs()),
        }
    }

    pub(super) fn same(
        &self,
        index: usize,
        left: &[Outcome<Answer>],
        right: &[Outcome<Answer>],
    ) -> bool {
        let pair = left.get(index).zip(right.get(index));
        pair.is_some_and(|(left, right)| self.exercise.same(&self.cases[index], left, right))
    }

    pub(super) fn all_same(&self, left: &[Outcome<Answer>], right: &[Outcome<Answer>]) -> bool {
        (0..self.cases.len()).all(|index| self.same(index, left, right))
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg32;

    use super::super::diagnosis::debug;
    use super::super::example::{
        Case, discriminant, exercise, forgot_four, forgot_square, negated,
    };
    use super::super::outcome::{Outcome, attempt};
    use super::super::verdict::{Status, Verdict};
    use super::super::{Exercise, Mistake};
    use crate::stats::estimate::Estimate;
    use crate::stats::running::Running;

    fn judge(yours: fn(&Case) -> f32) -> Verdict {
        let proven = exercise(yours).prove(debug).expect("the example has no flaw");
        let cases = (proven.exercise().cases)();
        proven.verdict(&cases.iter().map(|case| attempt(yours, case)).collect::<Vec<_>>())
    }

    #[test]
    fn an_untouched_stub_is_not_started() {
        let verdict = judge(|_| todo!("exercise 1.2"));
        assert_eq!(verdict, Verdict::not_started(4, None));
    }

    #[test]
    fn a_stub_that_is_needed_first_is_named() {
        let verdict = judge(|_| todo!("exercise 1.1"));
        assert_eq!(verdict.status, Status::NotStarted);
        assert!(verdict.diagnosis.is_some_and(|text| text.contains("1.1")));
    }

    #[test]
    fn right_is_done() {
        assert_eq!(judge(|case| case.b * case.b - 4.0 * case.a * case.c), Verdict::done(4));
    }

    #[test]
    fn each_mistake_is_recognised() {
        for (yours, name) in [
            (forgot_four as fn(&Case) -> f32, "the factor 4 is missing"),
            (forgot_square, "b is not squared"),
            (negated, "the sign is turned around"),
        ] {
            let verdict = judge(yours);
            assert_eq!((verdict.status, verdict.mistake), (Status::Wrong, Some(name)));
        }
    }

    #[test]
    fn what_no_mistake_explains_shows_the_first_difference() {
        let verdict = judge(|case| if case.a > 2.0 { 7.0 } else { discriminant(case) });
        assert_eq!((verdict.status, verdict.mistake), (Status::Wrong, None));
        assert_eq!((verdict.differing, verdict.cases), (1, 4));
        let first = verdict.first.expect("a case differs");
        assert_eq!(
            (first.index, first.expected.as_str(), first.yours.as_str()),
            (2, "-23.0", "7.0")
        );
        assert_eq!(first.case, "Case { a: 3.0, b: 1.0, c: 2.0 }");
    }

    #[test]
    fn a_panic_is_told_with_its_case() {
        let verdict = judge(|case| {
            assert!(case.a < 3.0, "no parabola");
            discriminant(case)
        });
        let diagnosis = verdict.diagnosis.expect("it is wrong");
        assert!(
            diagnosis.contains("proof.rs:") && diagnosis.contains("no parabola"),
            "{diagnosis}"
        );
        assert_eq!(verdict.first.map(|first| first.index), Some(2));
    }

    #[test]
    fn half_a_stub_is_wrong_and_not_untouched() {
        let verdict =
            judge(|case| if case.a < 3.0 { discriminant(case) } else { todo!("exercise 1.2") });
        assert_eq!(verdict.status, Status::Wrong);
        assert!(verdict.diagnosis.is_some_and(|text| text.contains("still reach the stub")));
    }

    #[test]
    fn answers_that_end_early_are_wrong() {
        let proven = exercise(discriminant).prove(debug).expect("the example has no flaw");
        let late = Outcome::Late(std::time::Duration::from_secs(3));
        let verdict = proven.verdict(&[Outcome::Answered(1.0), late]);
        assert_eq!((verdict.status, verdict.differing), (Status::Wrong, 3));
        assert_eq!(proven.verdict(&[]).differing, 4);
        assert!(verdict.diagnosis.is_some_and(|text| text.contains("in 3 s")));
    }

    #[test]
    fn a_mistake_may_panic_and_is_recognised_by_it() {
        let mistake = Mistake {
            name: "it divides by zero",
            diagnosis: "You divide by a - 1.",
            answer: |case: &Case| (10 / (case.a as i32 - 1)) as f32,
        };
        let mut example = exercise(discriminant);
        example.mistakes.push(mistake);
        let proven = example.prove(debug).expect("it is told from the others");
        let yours: fn(&Case) -> f32 = |case| [10.0, 5.0][usize::from(case.a as u8 + 9 - 10) - 1];
        let cases = (proven.exercise().cases)();
        let outcomes: Vec<_> = cases.iter().map(|case| attempt(yours, case)).collect();
        assert!(matches!(outcomes[0], Outcome::Panicked(_)));
        assert_eq!(proven.verdict(&outcomes).mistake, Some("it divides by zero"));
    }

    /// The mean of n numbers in [0, 1), each raised by what `bend` does to it.
    fn mean(seed: u64, bend: fn(f64) -> f64) -> Estimate {
        let mut random = Pcg32::seed_from_u64(seed);
        let samples: Running = (0..4096).map(|_| bend(random.random())).collect();
        Estimate::of(&samples).expect("there are 4096")
    }

    #[test]
    fn a_random_answer_is_judged_by_statistics() {
        let mistake = |name, answer| Mistake { name, diagnosis: "Biased.", answer };
        let exercise = Exercise {
            chapter: exercise(discriminant).chapter,
            number: "11.1",
            title: "The mean of a square",
            section: "Estimators",
            cases: || vec![1_u64, 2, 3],
            expected: |_| Estimate::exact(1.0 / 3.0),
            agree: |_, expected, yours| expected.agrees(yours, 1e-4),
            yours: |_| todo!("exercise 11.1"),
            solution: |seed| mean(*seed, |x| x * x),
            mistakes: vec![
                mistake("not squared", |seed| mean(*seed, |x| x)),
                mistake("cubed", |seed| mean(*seed, |x| x * x * x)),
                mistake("a tenth too bright", |seed| mean(*seed, |x| 1.1 * x * x)),
            ],
        };
        let proven = exercise.prove(debug).expect("the noise is less than the bias");
        let judge = |yours: fn(&u64) -> Estimate| {
            proven.verdict(&[1, 2, 3].map(|seed| attempt(yours, &seed)))
        };
        // Other random numbers than the solution's or the mistake's.
        assert_eq!(judge(|seed| mean(seed + 10, |x| x * x)).status, Status::Done);
        let bright = judge(|seed| mean(seed + 10, |x| 1.1 * x * x));
        assert_eq!(bright.mistake, Some("a tenth too bright"));
    }
}
