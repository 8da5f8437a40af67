//! Chapter 3's program: the same picture, triangle by triangle.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::chapter::main(&object_order::command::PROGRAM)
}
