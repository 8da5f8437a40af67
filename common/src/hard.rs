//! The ledger of hard cases: inputs on which the textbook formula fails and the robust one doesn't.
//!
//! A case is an experiment. A trial makes an input from its number and asks whether a formula got
//! it wrong; an independent oracle (exact integers, `f64`, a closed form) decides. The naive
//! formula is the negative control: if it never failed, the experiment would prove nothing.

pub mod pixels;

use std::fmt;

/// One hard case: an experiment on a naive and on a robust formula.
#[derive(Clone, Copy)]
pub struct Case {
    /// The name in the ledger, such as "RC-01".
    pub id: &'static str,
    /// The chapter that teaches it, such as "01-ray-casting".
    pub chapter: &'static str,
    /// What is hard about the input, in a few words.
    pub input: &'static str,
    /// How many trials there are at most; a case with a fixed table of inputs has one each.
    pub most: u64,
    /// Whether the naive formula gets trial number so-and-so wrong.
    pub naive_fails: fn(u64) -> bool,
    /// Whether the robust formula does.
    pub robust_fails: fn(u64) -> bool,
}

/// The most trials of a case that draws its inputs at random.
pub const UNLIMITED: u64 = u64::MAX;

/// How often a case without a limit has to be tried before its naive formula must have failed.
pub const ENOUGH: u64 = 1_000_000;

/// The outcome of one case.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Row {
    /// The name in the ledger.
    pub id: &'static str,
    /// The chapter that teaches it.
    pub chapter: &'static str,
    /// What is hard about the input.
    pub input: &'static str,
    /// How many inputs were tried.
    pub trials: u64,
    /// How many the naive formula got wrong; it must be some.
    pub naive_failures: u64,
    /// How many the robust formula got wrong; it must be none.
    pub robust_failures: u64,
    /// Whether it was tried as often as the ledger asks: all of its table, or a million inputs.
    #[serde(skip)]
    pub complete: bool,
}

impl Case {
    /// Runs `trials` trials, or as many as the case has.
    pub fn run(&self, trials: u64) -> Row {
        let trials = trials.min(self.most);
        Row {
            id: self.id,
            chapter: self.chapter,
            input: self.input,
            trials,
            naive_failures: count(trials, self.naive_fails),
            robust_failures: count(trials, self.robust_fails),
            complete: trials >= ENOUGH.min(self.most),
        }
    }
}

impl Row {
    /// Whether the robust formula never failed and the naive one did.
    pub fn holds(&self) -> bool {
        self.robust_failures == 0 && self.naive_failures > 0
    }
}

#[cfg(feature = "native")]
fn count(trials: u64, fails: fn(u64) -> bool) -> u64 {
    use rayon::prelude::{IntoParallelIterator, ParallelIterator};
    (0..trials).into_par_iter().filter(|&trial| fails(trial)).count() as u64
}

#[cfg(not(feature = "native"))]
fn count(trials: u64, fails: fn(u64) -> bool) -> u64 {
    (0..trials).filter(|&trial| fails(trial)).count() as u64
}

/// Rows of the ledger; prints as a table.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Ledger(pub Vec<Row>);

impl Ledger {
    /// Runs every case, `trials` times each or as often as it can be.
    pub fn of(cases: &[Case], trials: u64) -> Self {
        Self(cases.iter().map(|case| case.run(trials)).collect())
    }

    /// The rows that don't hold.
    pub fn broken(&self) -> Vec<&Row> {
        self.0.iter().filter(|row| !row.holds()).collect()
    }

    /// The broken rows that more trials can't mend: the robust formula failed, or the naive one did
    /// not in as many trials as the ledger asks for.
    pub fn refuted(&self) -> Vec<&Row> {
        let refuted = |row: &&Row| row.complete || row.robust_failures > 0;
        self.broken().into_iter().filter(refuted).collect()
    }

    /// The broken rows that may hold after all: they were tried too seldom for the naive formula to
    /// fail.
    pub fn unfinished(&self) -> Vec<&Row> {
        let unfinished = |row: &&Row| !row.complete && row.robust_failures == 0;
        self.broken().into_iter().filter(unfinished).collect()
    }
}

impl fmt::Display for Ledger {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let width = self.0.iter().map(|row| row.input.chars().count()).max().unwrap_or(0).max(5);
        writeln!(out, "case   {:width$}     trials naive fails robust fails", "input")?;
        for row in &self.0 {
            writeln!(
                out,
                "{:6} {:width$} {:>10} {:>11} {:>12}",
                row.id, row.input, row.trials, row.naive_failures, row.robust_failures
            )?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Case, ENOUGH, Ledger, UNLIMITED};

    const CASE: Case = Case {
        id: "TT-01",
        chapter: "00-test",
        input: "every third number",
        most: UNLIMITED,
        naive_fails: |trial| trial % 3 == 0,
        robust_fails: |_| false,
    };

    #[test]
    fn failures_are_counted_exactly() {
        let row = CASE.run(1_000_000);
        assert_eq!((row.naive_failures, row.robust_failures), (333_334, 0));
        assert!(row.holds());
    }

    #[test]
    fn a_table_is_never_longer_than_itself() {
        assert_eq!(Case { most: 48, ..CASE }.run(1_000_000).trials, 48);
    }

    #[test]
    fn a_control_that_never_fails_breaks_the_ledger() {
        let tame = Case { naive_fails: |_| false, ..CASE };
        let flawed = Case { robust_fails: |trial| trial == 7, ..CASE };
        assert_eq!(Ledger::of(&[CASE, tame, flawed], 10).broken().len(), 2);
        assert_eq!(Ledger::of(&[CASE, tame, flawed], ENOUGH).refuted().len(), 2);
        let table = Case { most: 10, ..tame };
        assert_eq!(Ledger::of(&[table], 20).refuted().len(), 1, "a table that was run whole");
    }

    #[test]
    fn too_few_trials_are_no_failure_of_the_case() {
        let rare = Case { naive_fails: |trial| trial == 50, ..CASE };
        let flawed = Case { robust_fails: |trial| trial == 7, ..rare };
        let table = Case { most: 60, ..rare };
        let few = Ledger::of(&[CASE, rare, flawed, table], 10);
        assert_eq!((few.refuted().len(), few.unfinished().len()), (1, 2));
        let more = Ledger::of(&[CASE, rare, table], 100);
        assert_eq!((more.refuted().len(), more.unfinished().len()), (0, 0));
    }
}
