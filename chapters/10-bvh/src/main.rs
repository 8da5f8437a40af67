//! `cargo run --release -p bvh`: the picture of chapter 10.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&bvh::command::PROGRAM)
}
