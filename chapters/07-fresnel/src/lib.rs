//! Chapter 7: glass and metal, what is reflected and what goes through.

pub mod bend;
pub mod conductor;
pub mod dielectric;
pub mod exercises;
pub mod glass;
pub mod hard;
pub mod index;
pub mod inside;
pub mod integrator;
pub mod interface;
pub mod mtl;
pub mod naive;
pub mod passage;
pub mod path;
pub mod radiance;
pub mod schlick;
pub mod shade;
pub mod slab;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod picture;
#[cfg(feature = "native")]
pub mod scenes;
