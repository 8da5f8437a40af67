//! Chapter 15: rough metal and rough glass.

pub mod conductor;
pub mod dielectric;
pub mod facets;
pub mod finish;
pub mod ggx;
pub mod rough;
