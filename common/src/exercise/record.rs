//! A verdict as it is printed, and as the front door reads it.

use std::fmt;

use serde::Serialize;

use super::Exercise;
use super::verdict::{Status, Verdict};

/// A verdict together with the exercise it is about: the JSON object in
/// `out/exercises/<NN-K>.json`, whose keys are these fields and those of [`Verdict`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Record {
    /// "1.2".
    pub number: &'static str,
    /// A few words.
    pub title: &'static str,
    /// The chapter's package.
    pub package: &'static str,
    /// The section of the chapter's page to read again.
    pub section: &'static str,
    /// The verdict.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// The page that compares the pictures, when there is one.
    pub page: Option<String>,
}

impl Record {
    /// The record of `verdict` on `exercise`, without a page.
    pub fn new<Case, Answer>(exercise: &Exercise<Case, Answer>, verdict: Verdict) -> Self {
        Self {
            number: exercise.number,
            title: exercise.title,
            package: exercise.chapter.package,
            section: exercise.section,
            verdict,
            page: None,
        }
    }
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Verdict { status, mistake, diagnosis, differing, cases, first } = &self.verdict;
        write!(f, "exercise {} \"{}\": {}", self.number, self.title, status.words())?;
        if let Some(mistake) = mistake {
            write!(f, " ({mistake})")?;
        }
        if let Some(diagnosis) = diagnosis {
            write!(f, "\n  {diagnosis}")?;
        }
        if *status != Status::Wrong {
            return Ok(());
        }
        write!(f, "\n  Read again: \"{}\".", self.section)?;
        if let Some(first) = first {
            writeln!(f, "\n\n  {differing} of {cases} cases differ. The first:")?;
            writeln!(f, "    case      {}", first.case)?;
            writeln!(f, "    expected  {}", first.expected)?;
            write!(f, "    yours     {}", first.yours)?;
        }
        if let Some(page) = &self.page {
            write!(f, "\n\n  Both pictures and their difference: {page}")?;
        }
        write!(f, "\n\n  Once more: cargo test -p {} --test exercises", self.package)
    }
}
