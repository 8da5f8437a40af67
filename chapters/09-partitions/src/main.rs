//! Chapter 9's program: `cargo run --release -p partitions`.

use std::process::ExitCode;

use partitions::command::Partitions;

fn main() -> ExitCode {
    common::chapter::main::<Partitions>()
}
