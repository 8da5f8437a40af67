//! `cargo run --release -p multiple-importance`: the picture of chapter 16.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&multiple_importance::command::PROGRAM)
}
