//! Chapter 1: one ray for each pixel.
//!
//! A picture is a question asked once for each pixel: what is there, in that direction? The
//! question is a [`ray`], a [`camera`] asks it, a [`shape`] answers. This chapter builds on nothing
//! but `common`.
//!
//! ```text
//! cargo run --release -p ray-casting
//! cargo run --release -p ray-casting -- --scene far --sphere naive
//! cargo run --release -p ray-casting -- cost
//! cargo run --release -p ray-casting -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`ray`] | a half-line: an origin and a direction |
//! | [`direction`] | vectors of length 1, from vectors of any length |
//! | [`camera`] | which ray belongs to which pixel |
//! | [`shape`] | what a ray can hit, and the nearest hit of several |
//! | [`sphere`], [`plane`], [`quad`] | three shapes |
//! | [`crossing`] | where a line goes in and out |
//! | [`rounding`] | how wrong a computed point may be |
//! | [`longitude`] | where on a sphere a point is |
//! | [`scene`] | shapes and a view together: the report's spheres, and scenes that hurt |
//! | [`picture`] | what a pixel shows of what its ray hit |
//! | [`naive`] | the textbook's formulas, which fail |
//! | [`double`] | the sphere in `f64`, and the reference for the others |
//! | [`hard`] | inputs on which the naive formulas fail and ours don't |
//! | `cost` | what accuracy costs in nanoseconds |
//! | `command`, `knobs` | the program and its options |
//! | [`exercises`] | yours to write |

pub mod camera;
pub mod crossing;
pub mod direction;
pub mod double;
pub mod exercises;
pub mod hard;
pub mod longitude;
pub mod naive;
pub mod picture;
pub mod plane;
pub mod quad;
pub mod ray;
pub mod rounding;
pub mod scene;
pub mod shape;
pub mod sphere;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
