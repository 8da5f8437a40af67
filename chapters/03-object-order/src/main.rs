//! Chapter 3's program: the same picture, triangle by triangle.

use std::process::ExitCode;

use object_order::command::ObjectOrder;

fn main() -> ExitCode {
    common::chapter::main::<ObjectOrder>()
}
