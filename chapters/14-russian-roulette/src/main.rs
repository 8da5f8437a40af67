//! `cargo run --release -p russian-roulette`: the picture of chapter 14.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&russian_roulette::command::PROGRAM)
}
