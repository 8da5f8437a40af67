//! Chapter 8: boxes around things.

pub mod aabb;
pub mod bounded;
pub mod slab;
