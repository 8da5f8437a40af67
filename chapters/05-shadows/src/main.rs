//! `cargo run --release -p shadows`: the picture of chapter 5.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&shadows::command::PROGRAM)
}
