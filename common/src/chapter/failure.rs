//! What ends a chapter's program early, and with which exit code.

use std::io;
use std::path::Path;
use std::process::ExitCode;

/// Why a program could not do what it was asked.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The command line is wrong: exit code 2.
    #[error("{0}")]
    Usage(String),
    /// The command line parser's own messages, `--help` among them.
    #[error("{0}")]
    CommandLine(#[from] clap::Error),
    /// The work failed: exit code 1.
    #[error("{0}")]
    Work(String),
    /// Whoever read our output stopped reading, or it can't be written: exit code 1.
    #[error(
        "standard output can't be written: {0}; it may have been closed before all was printed"
    )]
    Output(#[from] io::Error),
}

impl Failure {
    /// The failure to write the file at `path`.
    pub fn writing(path: &Path, error: &io::Error) -> Self {
        let path = path.display();
        Self::Work(format!("can't write '{path}': {error}; choose another place with --out"))
    }

    /// Says on standard error what went wrong, and gives the exit code.
    pub fn report(&self) -> ExitCode {
        use io::Write;
        if let Self::CommandLine(error) = self {
            // Help goes to standard output, and a closed one is no reason to panic.
            let printed = error.print();
            let code = if printed.is_err() { 1 } else { error.exit_code() };
            return ExitCode::from(u8::try_from(code).unwrap_or(2));
        }
        // Nobody is left to tell when standard error is closed too.
        let _told = writeln!(io::stderr(), "error: {self}");
        ExitCode::from(if matches!(self, Self::Usage(_)) { 2 } else { 1 })
    }
}
