//! Chapter 7: glass and metal, what is reflected and what goes through.

pub mod bend;
pub mod conductor;
pub mod dielectric;
pub mod hard;
pub mod index;
pub mod interface;
pub mod naive;
pub mod radiance;
pub mod schlick;
pub mod slab;
