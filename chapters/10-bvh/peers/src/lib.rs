//! Chapter 10's tree beside two others from the registry, on the same meshes and rays.

pub mod rays;
pub mod rivals;
