//! `cargo run --release -p microfacets`: the picture of chapter 15.

fn main() {}
