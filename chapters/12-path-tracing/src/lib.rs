//! Chapter 12: the rendering equation, one path at a time.
//!
//! Light that a surface sends on came from other surfaces. The rendering equation says so in a line,
//! and this chapter estimates it: along one path at a time, whose directions are chosen by chance. It
//! builds on [`monte_carlo`]'s estimators and directions, on [`bvh`]'s tree, on [`shadows`]' rays that
//! leave a surface, and on [`fresnel`]'s glass.
//!
//! ```text
//! cargo run --release -p path-tracing
//! cargo run --release -p path-tracing -- --scene cornell-glass --spp 256
//! cargo run --release -p path-tracing -- --scene furnace --albedo 0.9 --depth 100
//! cargo run --release -p path-tracing -- --scene assets/two-materials.obj
//! cargo run --release -p path-tracing -- cost
//! cargo run --release -p path-tracing -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`bsdf`] | what every material can be asked |
//! | [`lambert`], [`mirror`], [`glass`], [`smooth`] | this chapter's materials |
//! | [`random`] | random numbers, each found by what it is for |
//! | [`part`], [`model`], [`mtl`] | scenes as they are described, and their files |
//! | [`space`], [`world`], [`stage`] | scenes as paths see them |
//! | [`vertex`] | where a path met a surface, and how it left it |
//! | [`strategy`] | the two choices that later chapters make: how light is looked for, when paths end |
//! | [`tracer`] | following one path |
//! | [`branching`] | following many, which grows beyond all bounds |
//! | [`furnace`] | closed rooms whose light is known |
//! | [`shot`] | from a plan to a picture |
//! | [`naive`] | the textbook's formulas, which fail |
//! | [`hard`] | inputs on which the naive formulas fail and ours don't |
//! | `cost` | what accuracy costs in time |
//! | `scenes`, `knobs`, `command` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod branching;
pub mod bsdf;
pub mod exercises;
pub mod furnace;
pub mod glass;
pub mod hard;
pub mod lambert;
pub mod mirror;
pub mod model;
pub mod mtl;
pub mod naive;
pub mod part;
pub mod random;
pub mod shot;
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
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;
