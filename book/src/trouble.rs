//! What goes wrong while the book is made, and the exit code for it.

use std::fmt;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use common::interrupt;

/// Something wrong on a page.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Problem {
    /// The page's file, such as "book/text/01-ray-casting.md".
    pub page: String,
    /// Its line, from 1; 0 for the page as a whole.
    pub line: usize,
    /// What is wrong and what to do.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let Self { page, line, message } = self;
        match line {
            0 => write!(out, "{page}: {message}"),
            line => write!(out, "{page}:{line}: {message}"),
        }
    }
}

/// Why the program ends early.
#[derive(Debug, thiserror::Error)]
pub enum Trouble {
    /// The command line is wrong: exit code 2.
    #[error("{0}")]
    Usage(String),
    /// The command line parser's own messages, `--help` among them.
    #[error("{0}")]
    CommandLine(#[from] clap::Error),
    /// The work failed: exit code 1.
    #[error("{0}")]
    Work(String),
    /// The book's text is wrong: exit code 1.
    #[error("{}", listed(.0))]
    Problems(Vec<Problem>),
    /// Ctrl-C: exit code 130.
    #[error("stopped by Ctrl-C; the figures made so far are kept in out/cache")]
    Interrupted,
    /// Standard output can't be written: exit code 1.
    #[error("standard output can't be written: {0}; it may have been closed")]
    Output(#[from] io::Error),
}

impl Trouble {
    /// The failure to do something with the file or folder at `path`.
    pub fn with(path: &Path, error: &io::Error) -> Self {
        Self::Work(format!("{}: {error}; check that it is there and may be used", path.display()))
    }

    /// Says on standard error what went wrong, and gives the exit code.
    pub fn report(&self) -> ExitCode {
        if let Self::CommandLine(error) = self {
            // Help goes to standard output, and a closed one is no reason to panic.
            let code = if error.print().is_err() { 1 } else { error.exit_code() };
            return ExitCode::from(u8::try_from(code).unwrap_or(2));
        }
        match self {
            // Who presses Ctrl-C has made no error.
            Self::Interrupted => say(format_args!("{self}")),
            _ => say(format_args!("error: {self}")),
        }
        ExitCode::from(match self {
            Self::Usage(_) | Self::CommandLine(_) => 2,
            Self::Interrupted => interrupt::EXIT_CODE,
            Self::Work(_) | Self::Problems(_) | Self::Output(_) => 1,
        })
    }
}

/// Writes a line to standard error. Nobody is left to tell when that is closed too.
pub fn say(message: fmt::Arguments) {
    let _told = writeln!(io::stderr(), "{message}");
}

fn listed(problems: &[Problem]) -> String {
    let mut text = match problems.len() {
        1 => "the book was not built, for one reason:".to_string(),
        count => format!("the book was not built, for {count} reasons:"),
    };
    for problem in problems {
        text += &format!("\n{problem}");
    }
    text
}
