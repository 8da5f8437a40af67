//! What can be wrong with an exercise itself, and the search for it.

use std::fmt::Debug;

use super::diagnosis::is_stub;
use super::outcome::Outcome;
use super::proof::Proven;
use super::verdict::Status;

/// The fewest mistakes an exercise knows.
const MISTAKES: usize = 3;

/// What makes an exercise unfit to judge anybody.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Flaw {
    /// There is nothing to ask.
    #[error("it has no cases")]
    NoCases,
    /// Fewer than three mistakes.
    #[error("it knows {0} mistakes; three are the least")]
    FewMistakes(usize),
    /// The oracle has no answer, or one that doesn't agree with itself.
    #[error("the oracle fails on case {0}")]
    Oracle(usize),
    /// The solution is not what the oracle expects.
    #[error("the solution fails on case {index}: expected {expected}, got {yours}")]
    Solution {
        /// The case, from 0.
        index: usize,
        /// The oracle's answer.
        expected: String,
        /// The solution's.
        yours: String,
    },
    /// A mistake has no diagnosis.
    #[error("the mistake '{0}' has no diagnosis")]
    NoDiagnosis(&'static str),
    /// Two mistakes have one name.
    #[error("two mistakes are named '{0}'")]
    SameName(&'static str),
    /// A mistake is right on every case.
    #[error("the mistake '{0}' passes every case; add one that it fails")]
    Passes(&'static str),
    /// No case tells two mistakes apart.
    #[error("no case tells the mistake '{0}' from '{1}'; add one that does")]
    Alike(&'static str, &'static str),
    /// A mistake's answers don't agree with themselves, or it runs into a stub.
    #[error("the mistake '{0}' is not recognised as itself")]
    NotItself(&'static str),
}

impl<Case: Debug, Answer: Debug> Proven<Case, Answer> {
    /// All flaws; `solution` has the solution's answers. Nothing is proven while there are any.
    pub(super) fn flaws(&self, solution: &[Outcome<Answer>]) -> Vec<Flaw> {
        let mut flaws = self.flaws_of_form();
        flaws.extend(self.flaw_of_solution(solution));
        flaws.extend(self.flaws_of_mistakes());
        flaws
    }

    fn flaws_of_form(&self) -> Vec<Flaw> {
        let mut flaws = Vec::new();
        let mistakes = &self.exercise.mistakes;
        if self.cases.is_empty() {
            flaws.push(Flaw::NoCases);
        }
        if mistakes.len() < MISTAKES {
            flaws.push(Flaw::FewMistakes(mistakes.len()));
        }
        for (index, mistake) in mistakes.iter().enumerate() {
            if mistake.diagnosis.trim().is_empty() {
                flaws.push(Flaw::NoDiagnosis(mistake.name));
            }
            if mistakes[..index].iter().any(|other| other.name == mistake.name) {
                flaws.push(Flaw::SameName(mistake.name));
            }
        }
        flaws
    }

    fn flaw_of_solution(&self, solution: &[Outcome<Answer>]) -> Option<Flaw> {
        let fails = |index: &usize| {
            let answered = matches!(self.expected[*index], Outcome::Answered(_));
            !answered || !self.same(*index, &self.expected, &self.expected)
        };
        if let Some(index) = (0..self.cases.len()).find(fails) {
            return Some(Flaw::Oracle(index));
        }
        let index =
            (0..self.cases.len()).find(|&index| !self.same(index, &self.expected, solution))?;
        let expected = self.show(&self.expected[index]);
        Some(Flaw::Solution { index, expected, yours: self.show(&solution[index]) })
    }

    /// Judges the answers of each mistake as if they were a reader's.
    fn flaws_of_mistakes(&self) -> Vec<Flaw> {
        let mut flaws = Vec::new();
        for (index, mistake) in self.exercise.mistakes.iter().enumerate() {
            let answers = &self.mistaken[index];
            let verdict = self.verdict(answers);
            if verdict.status == Status::Done {
                flaws.push(Flaw::Passes(mistake.name));
            } else if !self.all_same(answers, answers) || answers.iter().any(is_stub) {
                flaws.push(Flaw::NotItself(mistake.name));
            }
            let alike = self.mistaken[..index].iter().position(|earlier| {
                self.all_same(earlier, answers) || self.all_same(answers, earlier)
            });
            if let Some(earlier) = alike {
                flaws.push(Flaw::Alike(self.exercise.mistakes[earlier].name, mistake.name));
            }
        }
        flaws
    }
}

#[cfg(test)]
mod tests {
    use super::super::Exercise;
    use super::super::diagnosis::debug;
    use super::super::example::{Case, discriminant, exercise, forgot_four};
    use super::Flaw;

    fn flaws(change: impl Fn(&mut Exercise<Case, f32>)) -> Vec<Flaw> {
        let mut flawed = exercise(discriminant);
        change(&mut flawed);
        flawed.prove(debug).err().unwrap_or_default()
    }

    #[test]
    fn a_mistake_that_passes_is_a_flaw() {
        let flaws = flaws(|exercise| exercise.mistakes[1].answer = |case| discriminant(case) + 0.0);
        assert_eq!(flaws, [Flaw::Passes("b is not squared")]);
    }

    #[test]
    fn two_mistakes_that_are_one_are_a_flaw() {
        let flaws = flaws(|exercise| exercise.mistakes[2].answer = forgot_four);
        let alike = Flaw::Alike("the factor 4 is missing", "the sign is turned around");
        assert_eq!(flaws, [alike]);
    }

    #[test]
    fn a_wrong_solution_or_oracle_is_a_flaw() {
        let solution = flaws(|exercise| exercise.solution = forgot_four);
        assert!(matches!(&solution[..], [Flaw::Solution { index: 0, .. }]));
        let oracle = flaws(|exercise| exercise.expected = |_| panic!("no answer"));
        assert_eq!(oracle[0], Flaw::Oracle(0));
    }

    #[test]
    fn a_mistake_that_runs_into_a_stub_is_a_flaw() {
        let flaws = flaws(|exercise| exercise.mistakes[0].answer = |_| todo!("exercise 1.2"));
        assert_eq!(flaws, [Flaw::NotItself("the factor 4 is missing")]);
    }

    #[test]
    fn a_mistake_that_gives_nan_must_agree_with_itself() {
        let flaws = flaws(|exercise| {
            exercise.agree = |_, expected, yours| (expected - yours).abs() <= 1e-6;
            exercise.mistakes[0].answer = |case| (-1.0 - case.a).sqrt();
        });
        assert_eq!(flaws, [Flaw::NotItself("the factor 4 is missing")]);
    }

    #[test]
    fn form_matters() {
        let few = flaws(|exercise| exercise.mistakes.truncate(2));
        assert_eq!(few, [Flaw::FewMistakes(2)]);
        let silent = flaws(|exercise| exercise.mistakes[0].diagnosis = " ");
        assert_eq!(silent, [Flaw::NoDiagnosis("the factor 4 is missing")]);
        let same = flaws(|exercise| exercise.mistakes[0].name = "b is not squared");
        assert_eq!(same, [Flaw::SameName("b is not squared")]);
        assert!(flaws(|exercise| exercise.cases = Vec::new).contains(&Flaw::NoCases));
    }
}
