//! Chapter 4: the light that lamps send, and what surfaces return of it.

pub mod light;
pub mod material;
pub mod object;
pub mod paint;
pub mod scene;
pub mod shading;
