//! Chapter 10.
mod bins; pub mod build; mod item; pub mod node; pub mod packed; mod pairs; pub mod plain; pub mod quality; pub mod seam; pub mod split; pub mod tree;
