//! `cost`: every experiment measured; a table on standard output, a CSV file and a plot.

use std::io::Write;
use std::process::ExitCode;

use super::picture::default_path;
use super::{Chapter, Failure};
use crate::args::CostArgs;
use crate::cost::{Table, chart, csv, measure};
use crate::files;

/// Measures the chapter's experiments.
pub(super) fn run<C: Chapter>(args: &CostArgs, out: &mut dyn Write) -> Result<ExitCode, Failure> {
    let plot = args.out.clone().unwrap_or_else(|| default_path(&format!("{}-cost", C::ID), "svg"));
    if plot.extension().is_none_or(|ending| ending != "svg") {
        let message = format!("'{}' must end in .svg (option --out)", plot.display());
        return Err(Failure::Usage(message));
    }
    let numbers = plot.with_extension("csv");
    for path in [&plot, &numbers] {
        files::check_writable(path).map_err(|error| Failure::writing(path, &error))?;
    }
    let mut tables: Vec<Table> = Vec::new();
    for experiment in C::cost() {
        let table = measure(experiment, usize::from(args.rounds));
        if !args.quiet {
            writeln!(out, "{table}")?;
            out.flush()?;
        }
        tables.push(table);
    }
    let picture = chart::svg(&tables).map_err(|error| Failure::Work(error.to_string()))?;
    for (path, text) in [(&plot, picture), (&numbers, csv(&tables))] {
        files::write_atomically(path, text.as_bytes())
            .map_err(|error| Failure::writing(path, &error))?;
    }
    if !args.quiet {
        writeln!(out, "written to {} and {}", plot.display(), numbers.display())?;
    }
    Ok(ExitCode::SUCCESS)
}
