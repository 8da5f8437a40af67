//! Chapter 8: boxes around things.
//!
//! Most rays miss most things. A box around a thing, with sides along the axes, is missed by most of
//! the rays that miss the thing, and asking it costs a fraction of the time. This chapter finds where
//! a ray meets a box, never saying no when the ray hits what is inside. It builds on
//! [`ray_casting`] and [`triangles`]: what the boxes are drawn around.
//!
//! ```text
//! cargo run --release -p boxes
//! cargo run --release -p boxes -- --accel none
//! cargo run --release -p boxes -- --boxes 64 --view work
//! cargo run --release -p boxes -- cost
//! cargo run --release -p boxes -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`aabb`] | a box by two corners; unions that no NaN can spoil |
//! | [`bounded`] | boxes around triangles, meshes, spheres and quads |
//! | [`slab`] | a ray made ready for many boxes, and the test that never loses a hit |
//! | [`naive`] | the test as it was published, form by form |
//! | [`oracle`] | the question in `f64` |
//! | [`parts`] | a mesh in parts, each behind a box |
//! | [`picture`], `wires` | what a pixel shows; edges of boxes |
//! | [`hard`] | inputs on which the published forms fail and ours doesn't |
//! | `cost` | what accuracy costs in nanoseconds |
//! | `command` | the program and its options |
//! | [`exercises`] | yours to write |

pub mod aabb;
pub mod bounded;
pub mod exercises;
pub mod hard;
pub mod naive;
pub mod oracle;
pub mod parts;
pub mod picture;
pub mod slab;
mod wires;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
