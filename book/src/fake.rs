//! A chapter for tests: it draws nothing and says what it was asked.

use std::ffi::OsString;
use std::hint::black_box;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use common::chapter::{Entry, Failure};
use common::cost::{Experiment, Method, Plot};
use common::hard::Case;

/// A book of one chapter.
pub(crate) const CHAPTERS: &[&Entry] = &[&Entry { id: "07-fake", run, hard, cost }];

fn run(arguments: &[OsString], out: &mut dyn Write) -> Result<ExitCode, Failure> {
    let words: Vec<&str> = arguments.iter().filter_map(|word| word.to_str()).collect();
    let after = |option: &str| {
        words.iter().position(|word| *word == option).and_then(|at| words.get(at + 1)).copied()
    };
    if after("--size") == Some("0x0") {
        return Err(Failure::Usage("a picture needs at least one pixel".into()));
    }
    let picture = Path::new(after("--out").unwrap_or("out/07-fake.png"));
    std::fs::write(picture, b"a picture").map_err(|error| Failure::writing(picture, &error))?;
    match (words.contains(&"hard"), words.contains(&"--json")) {
        (true, true) => writeln!(
            out,
            r#"[{{"id":"FA-01","chapter":"07-fake","input":"a < b","trials":4000,"naive_failures":130,"robust_failures":0}}]"#
        )?,
        (true, false) => writeln!(out, "FA-01 4000 130 0")?,
        (false, true) => writeln!(out, r#"{{"width":640,"counters":{{"rays":307200}}}}"#)?,
        (false, false) => writeln!(out, "0.1 s, written to {}", picture.display())?,
    }
    Ok(ExitCode::SUCCESS)
}

fn hard() -> Vec<Case> {
    Vec::new()
}

fn cost() -> Vec<Experiment<'static>> {
    let method = |label: &str, error| Method {
        label: label.into(),
        series: "all",
        size: 1.0,
        work: 100,
        error,
        run: Box::new(|| {
            black_box((0..1000).map(black_box).sum::<u64>());
        }),
    };
    vec![Experiment {
        name: "sums",
        title: "Sums & more",
        work_unit: "terms",
        error_metric: "RMS error",
        plot: Plot::ErrorOverTime("error"),
        methods: vec![method("exact", 0.0), method("naive, f32", 0.25)],
        note: |table| format!("{} methods.", table.rows.len()),
    }]
}
