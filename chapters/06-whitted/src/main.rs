//! Chapter 6's program: `cargo run --release -p whitted`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&whitted::command::PROGRAM)
}
