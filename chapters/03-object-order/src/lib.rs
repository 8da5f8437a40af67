//! Chapter 3: the same picture, triangle by triangle.
//!
//! Chapters 1 and 2 asked of each pixel which triangle it sees. Here each triangle is asked which
//! pixels it covers, and a z-buffer keeps the nearest. The two orders draw the same picture from
//! the same camera, and `--view difference` shows it, sample by sample.
//!
//! ```sh
//! cargo run --release -p object-order
//! ```
//!
//! Builds on `ray-casting` (the camera) and `triangles` (the mesh and the watertight ray test).
//!
//! | from the world to the film | filling it | comparing |
//! |---|---|---|
//! | [`project`]: one matrix, no division | [`edge`]: which samples a triangle covers | [`image`]: the ray caster |
//! | [`clip`]: what can't be divided goes | [`interpolate`]: depth at a sample | [`parity`]: do both orders agree? |
//! | [`fixed`]: the grid of 1/256 pixel | [`zbuffer`]: the nearest so far | [`naive`]: formulas that fail |
//! | [`setup`]: all of that for a mesh | [`raster`]: a triangle's pixels | [`hard`]: and how often |
//! | [`samples`]: where pixels are sampled | [`object`]: the whole picture | [`cost`]: time against size |

pub mod clip;
pub mod cost;
pub mod edge;
pub mod exercises;
pub mod fixed;
pub mod fragment;
pub mod hard;
pub mod image;
pub mod interpolate;
pub mod naive;
pub mod object;
pub mod parity;
pub mod project;
pub mod raster;
pub mod rasterizer;
pub mod reference;
pub mod samples;
pub mod setup;
pub mod shade;
pub mod zbuffer;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod scene;
