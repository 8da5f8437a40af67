//! Chapter 2's program: `cargo run --release -p triangles`.

use std::process::ExitCode;

use triangles::command::Triangles;

fn main() -> ExitCode {
    common::chapter::main::<Triangles>()
}
