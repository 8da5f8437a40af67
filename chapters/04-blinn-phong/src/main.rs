//! `cargo run --release -p blinn-phong`: the picture of chapter 4.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&blinn_phong::command::PROGRAM)
}
