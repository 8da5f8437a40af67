//! `cargo run --release -p fresnel`: the picture of chapter 7.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&fresnel::command::PROGRAM)
}
