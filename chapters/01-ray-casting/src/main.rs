//! `cargo run --release -p ray-casting`: the picture of chapter 1.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&ray_casting::command::PROGRAM)
}
