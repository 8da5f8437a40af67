//! Chapter 14: paths that end by chance, and are right on average.
//!
//! A path that is cut off at a depth loses light. One that ends by chance doesn't, on average, if those
//! that go on count for those that ended. It builds on [`path_tracing`], whose paths ask an ending
//! whether they go on, and on [`light_sampling`], which finds the light along them.
//!
//! ```text
//! cargo run --release -p russian-roulette
//! cargo run --release -p russian-roulette -- --roulette report
//! cargo run --release -p russian-roulette -- --roulette 0.2
//! cargo run --release -p russian-roulette -- --threshold 2
//! cargo run --release -p russian-roulette -- --paths single
//! cargo run --release -p russian-roulette -- cost
//! cargo run --release -p russian-roulette -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`roulette`] | survival that is constant, and survival by what a path carries |
//! | [`walk`], [`variance`] | paths in a furnace, and what chance does to them, in closed form |
//! | [`ending`] | the endings a picture may choose from |
//! | [`abreast`] | sixteen paths side by side, for scenes of a few matte triangles |
//! | [`naive`] | the report's line and the textbook's, which fail |
//! | [`hard`] | inputs on which they fail and ours don't |
//! | `cost` | what accuracy costs in time |
//! | `knobs`, `command` | the program and its options |
//! | [`exercises`] | yours to write |

pub mod abreast;
pub mod ending;
pub mod exercises;
pub mod hard;
pub mod naive;
pub mod roulette;
pub mod variance;
pub mod walk;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
