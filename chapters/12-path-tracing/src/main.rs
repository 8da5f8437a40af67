//! `cargo run --release -p path-tracing`: the picture of chapter 12.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&path_tracing::command::PROGRAM)
}
