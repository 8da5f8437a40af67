//! `cargo run --release -p monte-carlo`: the picture of chapter 11.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&monte_carlo::command::PROGRAM)
}
