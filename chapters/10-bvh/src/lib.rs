//! Chapter 10.
pub mod bins; pub mod build; pub mod item; pub mod node; pub mod split; pub mod tree; pub mod pairs; pub mod triangles;
