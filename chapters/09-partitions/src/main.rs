//! Chapter 9's program: `cargo run --release -p partitions`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&partitions::command::PROGRAM)
}
