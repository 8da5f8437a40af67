//! Chapter 12: the rendering equation, one path at a time.

pub mod bsdf;
pub mod glass;
pub mod lambert;
pub mod mirror;
pub mod model;
pub mod part;
pub mod random;
pub mod smooth;
pub mod space;
pub mod stage;
pub mod strategy;
pub mod tracer;
pub mod vertex;
pub mod world;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;
pub mod shot;
