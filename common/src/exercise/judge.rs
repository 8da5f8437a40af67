//! Judging a reader's code, natively: in time, with its verdict on file.

use std::fmt::{self, Debug};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use super::Exercise;
use super::diagnosis::debug;
use super::flaw::Flaw;
use super::outcome::{Outcome, attempt};
use super::picture::compare;
use super::place::{out_folder, stem};
use super::record::Record;
use super::verdict::{Status, Verdict};
use crate::files::write_atomically;
use crate::film::Film;

/// What a wrong answer fails its test with. Cargo prints it as it is: `Debug` is the message.
#[derive(thiserror::Error)]
#[error("{0}")]
pub struct Failure(String);

impl Debug for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

/// How long a reader's code may take: a while, or so many times what the oracle, the solution and
/// the mistakes took together on this machine at this moment.
pub(super) const PATIENCE: Patience = Patience { least: Duration::from_secs(10), times: 20 };

/// A limit of time, both ways.
#[derive(Clone, Copy)]
pub(super) struct Patience {
    least: Duration,
    times: u32,
}

/// How answers of one type are shown.
pub(super) struct Look<Answer> {
    pub(super) words: fn(&Answer) -> String,
    pub(super) picture: Option<fn(&Answer) -> &Film>,
}

impl<Case: Debug + 'static, Answer: Debug + Send + 'static> Exercise<Case, Answer> {
    /// Proves the exercise, judges the reader's code, and writes the verdict to
    /// `out/exercises/<NN-K>.json`: in the workspace of the chapter, or where the variable
    /// `FIRST_LIGHT_OUT` says.
    ///
    /// # Errors
    ///
    /// What to tell the reader, when their code is wrong. Another text when the exercise itself has
    /// a flaw; then their code is not judged.
    pub fn judge(self) -> Result<(), Failure> {
        let out = out_folder(Path::new(self.chapter.folder));
        report(self.judge_in(&out, PATIENCE, Look { words: debug, picture: None })?)
    }

    /// Judges for a given output folder and limit of time. The record is of right code or wrong.
    pub(super) fn judge_in(
        self,
        out: &Path,
        patience: Patience,
        look: Look<Answer>,
    ) -> Result<Record, Failure> {
        let file = out.join("exercises").join(stem(self.number));
        let begun = Instant::now();
        let mut record = Record::new(&self, Verdict::wrong(0, FLAWED.to_string()));
        let proven = self.prove(look.words).map_err(|flaws| {
            save(&record, &file);
            broken(&record, &flaws)
        })?;

        // Endless recursion ends the whole program; then this is the verdict that stays.
        record.verdict = Verdict::wrong(proven.expected().len(), ENDED.to_string());
        save(&record, &file);

        let limit = patience.least.max(begun.elapsed() * patience.times);
        let yours = answers_within(limit, proven.exercise());
        record.verdict = proven.verdict(&yours);
        if let Some(picture) = look.picture {
            compare(&mut record, proven.expected(), &yours, picture, &file);
        }
        save(&record, &file);
        Ok(record)
    }
}

const FLAWED: &str = "The check of this exercise is broken, so your code was not judged.";

const ENDED: &str = "The program ended while your code ran. Most often a function calls itself \
                     without end.";

/// Lets the test fail when the code is wrong.
pub(super) fn report(record: Record) -> Result<(), Failure> {
    if record.verdict.status == Status::Wrong {
        return Err(Failure(record.to_string()));
    }
    println!("{record}");
    Ok(())
}

fn broken(record: &Record, flaws: &[Flaw]) -> Failure {
    let flaws: Vec<String> = flaws.iter().map(|flaw| format!("\n  - {flaw}")).collect();
    let Record { number, title, .. } = record;
    Failure(format!("exercise {number} \"{title}\": {FLAWED}{}", flaws.concat()))
}

/// Runs the reader's code on a thread of its own, so that an endless loop can be left behind. The
/// answers end with a late one when the limit is reached.
fn answers_within<Case: 'static, Answer: Send + 'static>(
    limit: Duration,
    exercise: &Exercise<Case, Answer>,
) -> Vec<Outcome<Answer>> {
    let (cases, yours) = (exercise.cases, exercise.yours);
    let (sender, receiver) = mpsc::channel();
    let work = move || {
        // Nobody listens any more once the limit was reached: then the rest is in vain.
        let _ = cases().iter().try_for_each(|case| sender.send(attempt(yours, case)));
    };
    // The name is what a stack overflow is reported with. Without a thread there are no answers.
    let thread = thread::Builder::new().name(format!("exercise {}", exercise.number)).spawn(work);
    if let Err(error) = thread {
        eprintln!("cannot start a thread: {error}");
    }
    let end = Instant::now() + limit;
    let mut answers = Vec::new();
    loop {
        match receiver.recv_timeout(end.saturating_duration_since(Instant::now())) {
            Ok(answer) => answers.push(answer),
            Err(RecvTimeoutError::Timeout) => answers.push(Outcome::Late(limit)),
            Err(RecvTimeoutError::Disconnected) => return answers,
        }
        if matches!(answers.last(), Some(Outcome::Late(_))) {
            return answers;
        }
    }
}

/// Writes the JSON. When that fails the verdict still stands: a read-only folder makes no code
/// wrong.
fn save(record: &Record, file: &Path) {
    let path: PathBuf = file.with_extension("json");
    let written = serde_json::to_vec_pretty(record)
        .map_err(std::io::Error::from)
        .and_then(|json| write_atomically(&path, &json));
    if let Err(error) = written {
        eprintln!("cannot write {}: {error}", path.display());
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::time::Duration;

    use serde_json::Value;

    use super::super::diagnosis::debug;
    use super::super::example::{Case, discriminant, exercise, forgot_four};
    use super::super::record::Record;
    use super::{Failure, Look, Patience, report};

    const SHORT: Patience = Patience { least: Duration::from_millis(200), times: 0 };

    fn judge_in(out: &Path, yours: fn(&Case) -> f32) -> Result<Record, Failure> {
        exercise(yours).judge_in(out, SHORT, Look { words: debug, picture: None })
    }

    /// The text a failing test prints, and the JSON.
    fn judge(yours: fn(&Case) -> f32) -> (Result<(), String>, Value) {
        let out = tempfile::tempdir().expect("a temporary folder");
        let told = judge_in(out.path(), yours).and_then(report);
        let json = std::fs::read(out.path().join("exercises/01-2.json")).expect("it was written");
        let json = serde_json::from_slice(&json).expect("it is JSON");
        (told.map_err(|failure| format!("{failure:?}")), json)
    }

    #[test]
    fn an_untouched_stub_fails_no_test() {
        let (told, json) = judge(|_| todo!("exercise 1.2"));
        assert_eq!(told, Ok(()));
        assert_eq!(json["status"], "not started");
        assert_eq!(json["number"], "1.2");
        assert_eq!(json["title"], "Hit or miss");
    }

    #[test]
    fn right_is_done() {
        let (told, json) = judge(discriminant);
        assert_eq!((told, &json["status"]), (Ok(()), &Value::from("done")));
    }

    #[test]
    fn a_mistake_is_told_like_this() {
        let (told, json) = judge(forgot_four);
        let expected = r#"exercise 1.2 "Hit or miss": wrong (the factor 4 is missing)
  You took b² - ac. That is right only when b stands for half of it.
  Read again: "The discriminant".

  4 of 4 cases differ. The first:
    case      Case { a: 1.0, b: 3.0, c: 2.0 }
    expected  1.0
    yours     7.0

  Once more: cargo test -p common --test exercises"#;
        assert_eq!(told, Err(expected.to_string()));
        assert_eq!(json["status"], "wrong");
        assert_eq!(json["mistake"], "the factor 4 is missing");
        assert_eq!(json["first"]["yours"], "7.0");
        assert!(json["diagnosis"].as_str().is_some_and(|text| text.starts_with("You took")));
    }

    #[test]
    fn an_endless_loop_is_too_slow() {
        let (told, json) = judge(|case| {
            while std::hint::black_box(case.a) == 3.0 {
                std::thread::yield_now();
            }
            discriminant(case)
        });
        assert!(told.is_err_and(|text| text.contains("too slow") && text.contains("a: 3.0")));
        assert_eq!(json["first"]["index"], 2);
    }

    #[test]
    fn a_flaw_is_not_blamed_on_the_reader() {
        let out = tempfile::tempdir().expect("a temporary folder");
        let mut flawed = exercise(discriminant);
        flawed.solution = forgot_four;
        let told = flawed.judge_in(out.path(), SHORT, Look { words: debug, picture: None });
        let text = told.expect_err("the solution is wrong").to_string();
        assert!(text.contains("your code was not judged") && text.contains("the solution fails"));
    }

    #[test]
    fn a_folder_that_cannot_be_written_makes_no_code_wrong() {
        let file = tempfile::NamedTempFile::new().expect("a temporary file");
        assert!(judge_in(file.path(), discriminant).and_then(report).is_ok());
    }
}
