//! Chapter 8's program: `cargo run --release -p boxes`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&boxes::command::PROGRAM)
}
