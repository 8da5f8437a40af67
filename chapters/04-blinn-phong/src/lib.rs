//! Chapter 4: the light that lamps send, and what surfaces return of it.
//!
//! Chapter 1 found *what* a pixel sees. This one finds what colour it has: lamps send light, a
//! surface returns part of it, and how much depends on three directions. It builds on
//! [`ray_casting`] (rays, hits, the report's spheres) and [`triangles`] (meshes and their normals).
//!
//! ```text
//! cargo run --release -p blinn-phong
//! cargo run --release -p blinn-phong -- --scene low-lamp --model phong
//! cargo run --release -p blinn-phong -- --scene bunny
//! cargo run --release -p blinn-phong -- cost
//! cargo run --release -p blinn-phong -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`object`] | a shape and what it is made of |
//! | [`scene`] | objects, lamps, and where they are seen from |
//! | [`light`] | lamps near and far, and what arrives of them |
//! | [`paint`] | colours that vary over a surface |
//! | [`material`] | how much of the light a surface returns, and how |
//! | [`mtl`] | materials from files |
//! | [`models`] | Lambert, Phong, Blinn |
//! | [`energy`] | highlights that return no more light than they get |
//! | [`shading`] | what one lamp adds, and which side of a surface is seen |
//! | [`picture`] | what a pixel shows |
//! | [`calls`] | the effects a lit scene calls for |
//! | [`power`] | the power of a cosine, the same on every machine |
//! | [`squaring`] | powers by multiplication alone |
//! | [`naive`] | the formulas as printed, which fail |
//! | [`hard`] | inputs on which the printed formulas fail and ours don't |
//! | `cost` | what accuracy costs in nanoseconds, and what the plan saves |
//! | `scenes`, `command`, `knobs` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod calls;
pub mod energy;
pub mod exercises;
pub mod hard;
pub mod light;
pub mod material;
pub mod models;
pub mod mtl;
pub mod naive;
pub mod object;
pub mod paint;
pub mod picture;
pub mod power;
pub mod scene;
pub mod shading;
pub mod squaring;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;
