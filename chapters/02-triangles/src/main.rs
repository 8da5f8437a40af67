//! Chapter 2's program: `cargo run --release -p triangles`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&triangles::command::PROGRAM)
}
