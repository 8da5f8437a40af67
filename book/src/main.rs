//! Builds the book: `cargo run --release`, and `-- serve`, `-- exercises`, `-- figures`.

use std::process::ExitCode;

use book::chapters::CHAPTERS;
use book::cli;
use common::interrupt;

fn main() -> ExitCode {
    interrupt::listen();
    let mut out = std::io::stdout().lock();
    match cli::run(std::env::args_os(), CHAPTERS, &mut out) {
        Ok(()) => ExitCode::SUCCESS,
        Err(trouble) => trouble.report(),
    }
}
