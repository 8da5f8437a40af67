//! Chapter 8's program: `cargo run --release -p boxes`.

fn main() {}
