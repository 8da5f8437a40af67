//! Chapter 5: whether two points see each other.

pub mod calls;
pub mod exercises;
pub mod hard;
pub mod lighting;
pub mod naive;
pub mod occluder;
pub mod offset;
pub mod picture;
pub mod spawn;
pub mod visibility;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;
