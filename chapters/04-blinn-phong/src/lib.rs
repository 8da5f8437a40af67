//! Chapter 4: the light that lamps send, and what surfaces return of it.

pub mod calls;
pub mod light;
pub mod material;
pub mod models;
pub mod mtl;
pub mod object;
pub mod paint;
pub mod scene;
pub mod shading;

#[cfg(feature = "native")]
pub mod scenes;
