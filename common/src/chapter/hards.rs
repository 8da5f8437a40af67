//! `hard`: the chapter's part of the ledger, and a picture of a failure where there is one.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::picture::{Target, default_path};
use super::{Chapter, Failure};
use crate::args::HardArgs;
use crate::hard::{Ledger, Row};

/// Runs the chapter's hard cases.
pub(super) fn run<C: Chapter>(args: &HardArgs, out: &mut dyn Write) -> Result<ExitCode, Failure> {
    let ledger = Ledger::of(&C::hard(), args.trials);
    if args.json {
        writeln!(out, "{}", json!(ledger))?;
    } else {
        write!(out, "{ledger}")?;
    }
    if let Some(film) = C::hard_picture() {
        let path = args.out.clone();
        let path = path.unwrap_or_else(|| default_path(&format!("{}-hard", C::ID), "png"));
        let written = format!("picture written to {}", path.display());
        Target::new(path)?.write(&film)?;
        if !args.json {
            writeln!(out, "{written}")?;
        }
    }
    let unfinished = ledger.unfinished();
    if !args.json && !unfinished.is_empty() {
        let (trials, names) = (args.trials, names(&unfinished));
        writeln!(
            out,
            "note: {trials} trials are too few for {names} to show the naive formula fail; try more"
        )?;
    }
    out.flush()?;
    verdict(&ledger)
}

/// Success, or the names of all cases that don't hold.
fn verdict(ledger: &Ledger) -> Result<ExitCode, Failure> {
    let broken = ledger.refuted();
    if broken.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    let (cases, verb) = if broken.len() == 1 { ("case", "does") } else { ("cases", "do") };
    Err(Failure::Work(format!(
        "hard {cases} {} {verb} not hold: the robust formula must never fail and the naive one must",
        names(&broken)
    )))
}

fn names(rows: &[&Row]) -> String {
    rows.iter().map(|row| row.id).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::verdict;
    use crate::hard::{Case, Ledger, UNLIMITED};

    #[test]
    fn all_broken_cases_are_named_and_too_few_trials_are_no_error() {
        let tame = Case {
            id: "TT-01",
            chapter: "00-test",
            input: "every number",
            most: UNLIMITED,
            naive_fails: |_| false,
            robust_fails: |_| false,
        };
        assert!(verdict(&Ledger::of(&[tame], 10)).is_ok());
        let flawed = Case { id: "TT-02", robust_fails: |trial| trial == 3, ..tame };
        let table = Case { id: "TT-03", most: 5, ..tame };
        let message = verdict(&Ledger::of(&[tame, flawed, table], 10)).expect_err("two are broken");
        assert!(
            message.to_string().starts_with("hard cases TT-02, TT-03 do not hold"),
            "{message}"
        );
    }
}
