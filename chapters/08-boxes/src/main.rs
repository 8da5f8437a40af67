//! Chapter 8's program: `cargo run --release -p boxes`.

use std::process::ExitCode;

use boxes::command::Boxes;

fn main() -> ExitCode {
    common::chapter::main::<Boxes>()
}
