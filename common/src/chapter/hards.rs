//! `hard`: the chapter's part of the ledger, and a picture of a failure where there is one.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::picture::{Target, default_path};
use super::{Chapter, Failure};
use crate::args::HardArgs;
use crate::hard::Ledger;

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
    out.flush()?;
    match ledger.broken()[..] {
        [] => Ok(ExitCode::SUCCESS),
        [row, ..] => Err(Failure::Work(format!(
            "hard case {} does not hold: the robust formula must never fail and the naive one must",
            row.id
        ))),
    }
}
