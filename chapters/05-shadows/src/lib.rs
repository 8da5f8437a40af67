//! Chapter 5: whether two points see each other.
//!
//! A lamp lights a surface unless something is between them. That is a question of its own, shorter
//! than "what is the nearest thing that way", and the ray that asks it starts on a surface, which is
//! the hard part: a point is never quite where its surface is. This chapter builds on
//! [`ray_casting`], whose hits know how wrong they may be, on [`triangles`], and on the lamps and
//! materials of [`blinn_phong`].
//!
//! ```text
//! cargo run --release -p shadows
//! cargo run --release -p shadows -- --offset none
//! cargo run --release -p shadows -- --scene far --offset normal
//! cargo run --release -p shadows -- cost
//! cargo run --release -p shadows -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`occluder`] | any hit before a limit, instead of the nearest |
//! | [`visibility`] | whether two points see each other, the same from both ends |
//! | [`lighting`] | a surface under several lamps, each of which may be hidden |
//! | [`spawn`] | where a ray that leaves a surface has to start |
//! | [`naive`] | where others start it, and the report's test of visibility |
//! | [`offset`] | the cures to choose from |
//! | [`picture`] | what a pixel shows |
//! | [`calls`] | whether a scene calls for shadows |
//! | [`hard`] | rays on which the naive formulas fail and ours don't |
//! | `cost` | what accuracy costs in nanoseconds, and what the plan saves |
//! | `scenes`, `command`, `knobs` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod calls;
pub mod exercises;
pub mod hard;
pub mod lighting;
pub mod naive;
pub mod occluder;
pub mod offset;
pub mod picture;
pub mod spawn;
pub mod visibility;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;
