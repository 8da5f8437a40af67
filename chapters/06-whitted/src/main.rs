//! Chapter 6's program: `cargo run --release -p whitted`.

use std::process::ExitCode;

use whitted::command::Whitted;

fn main() -> ExitCode {
    common::chapter::main::<Whitted>()
}
