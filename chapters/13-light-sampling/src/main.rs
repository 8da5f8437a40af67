//! `cargo run --release -p light-sampling`: the picture of chapter 13.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&light_sampling::command::PROGRAM)
}
