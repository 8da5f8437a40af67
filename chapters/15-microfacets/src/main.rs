//! `cargo run --release -p microfacets`: the picture of chapter 15.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&microfacets::command::PROGRAM)
}
