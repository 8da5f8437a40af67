//! What is said of a reader's answers.

use serde::{Serialize, Serializer};

/// How far an exercise is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The stub is untouched.
    NotStarted,
    /// There is code, and an answer that is not the expected one.
    Wrong,
    /// All answers are right.
    Done,
}

impl Status {
    /// As people and the JSON have it: "not started", "wrong", "done".
    pub fn words(self) -> &'static str {
        match self {
            Self::NotStarted => "not started",
            Self::Wrong => "wrong",
            Self::Done => "done",
        }
    }
}

impl Serialize for Status {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.words())
    }
}

/// The verdict on a reader's answers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verdict {
    /// How far the exercise is.
    pub status: Status,
    /// The name of the mistake that was recognised.
    pub mistake: Option<&'static str>,
    /// What to do about it; whole sentences.
    pub diagnosis: Option<String>,
    /// How many cases differ from what was expected.
    pub differing: usize,
    /// How many cases there are.
    pub cases: usize,
    /// The first of those that differ.
    pub first: Option<Difference>,
}

/// A case whose answer was not the expected one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// Which case, from 0.
    pub index: usize,
    /// The input.
    pub case: String,
    /// The right answer.
    pub expected: String,
    /// The reader's.
    pub yours: String,
}

impl Verdict {
    /// The verdict on answers that are all right.
    pub fn done(cases: usize) -> Self {
        let status = Status::Done;
        Self { status, mistake: None, diagnosis: None, differing: 0, cases, first: None }
    }

    /// The verdict on a stub, perhaps because of another one that has to be done first.
    pub fn not_started(cases: usize, diagnosis: Option<String>) -> Self {
        let status = Status::NotStarted;
        Self { status, mistake: None, diagnosis, differing: 0, cases, first: None }
    }

    /// The verdict on code that gave no comparable answers.
    pub fn wrong(cases: usize, diagnosis: String) -> Self {
        let (status, diagnosis) = (Status::Wrong, Some(diagnosis));
        Self { status, mistake: None, diagnosis, differing: 0, cases, first: None }
    }
}
