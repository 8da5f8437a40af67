//! Chapter 2: triangles and meshes.
//!
//! Nearly everything that is drawn is made of triangles. This chapter finds where a ray meets one,
//! in such a way that no ray slips between two that share an edge, and draws a mesh of thousands by
//! asking each of them. It builds on [`ray_casting`]: rays, the camera, [`ray_casting::shape::Hit`].
//!
//! ```text
//! cargo run --release -p triangles
//! cargo run --release -p triangles -- --test naive --normals flat
//! cargo run --release -p triangles -- --scene sphere:100000 --size 160x120
//! cargo run --release -p triangles -- cost
//! cargo run --release -p triangles -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`intersect`] | what a ray-triangle test answers |
//! | [`naive`] | Möller and Trumbore's test, and other formulas that fail |
//! | [`watertight`] | a test that leaves no crack |
//! | [`lanes`] | the same for four triangles at once |
//! | [`reference`](mod@reference) | the question in `f64` |
//! | [`area`] | whether a triangle has an area, decided exactly |
//! | [`brute`] | the nearest hit among all triangles |
//! | [`mesh`] | triangles that share their vertices |
//! | [`bundle`], [`few`], [`nearest`] | sixteen rays at a time, against a few triangles |
//! | [`packed`] | a mesh as a shape, four triangles at a time |
//! | [`parts`] | a mesh in parts, one a material |
//! | [`closed`] | meshes that have an inside |
//! | [`surface`], [`smooth`] | normals of triangles, and between them |
//! | [`bunny`], [`bumpy`], [`convert`] | meshes built in, made up, and from files |
//! | [`calls`] | the effects a mesh and its materials call for |
//! | [`picture`] | what a pixel shows |
//! | [`hard`] | inputs on which the naive formulas fail and ours don't |
//! | `cost` | what accuracy costs in nanoseconds |
//! | `scene`, `command` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod area;
pub mod brute;
pub mod bumpy;
pub mod bundle;
pub mod bunny;
pub mod calls;
pub mod closed;
pub mod convert;
pub mod exercises;
pub mod few;
pub mod hard;
pub mod intersect;
pub mod lanes;
pub mod mesh;
pub mod naive;
pub mod nearest;
pub mod packed;
pub mod parts;
pub mod picture;
pub mod reference;
pub mod smooth;
pub mod surface;
pub mod watertight;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod scene;
