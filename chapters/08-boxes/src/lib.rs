//! Chapter 8: boxes around things.

pub mod aabb;
pub mod bounded;
pub mod hard;
pub mod naive;
pub mod oracle;
pub mod parts;
pub mod picture;
pub mod slab;
mod wires;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
