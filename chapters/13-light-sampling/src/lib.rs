//! Chapter 13: looking for light where it comes from.

pub mod by_light;
pub mod lamp;
pub mod lights;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;
