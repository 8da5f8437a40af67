//! Chapter 6: mirrors, and rays that are followed from mirror to mirror.
//!
//! A mirror shows what another ray sees, one that starts on it. This chapter follows such rays as far
//! as they count, in a loop that needs no stack, and takes care that each leaves its mirror. It builds
//! on [`blinn_phong`], for what surfaces return of lamps, and on [`shadows`], for lamps that are hidden
//! and for where a ray that leaves a surface starts.
//!
//! ```text
//! cargo run --release -p whitted
//! cargo run --release -p whitted -- --scene kaleidoscope --depth 40
//! cargo run --release -p whitted -- --scene facing-mirrors --depth 1000000
//! cargo run --release -p whitted -- cost
//! cargo run --release -p whitted -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`mirror`] | which way a mirror sends a ray, and where that one starts |
//! | [`material`], [`mtl`] | surfaces that mirror, from scenes and from files |
//! | [`scatter`] | the seam between what is followed and what it meets |
//! | [`limits`] | which branches are worth following |
//! | [`iteration`] | following them in a loop, with a list of what is left to do |
//! | [`recursion`] | the same by a function that calls itself |
//! | [`facing`], [`tree`] | mirrors and branches without geometry, whose light is known |
//! | [`world`] | a scene with mirrors, as something to follow rays through |
//! | [`picture`] | what a pixel shows |
//! | [`naive`] | the textbook's recursion, and lines that fail |
//! | [`hard`] | inputs on which the naive formulas fail and ours don't |
//! | `cost` | how far to follow, how to, and what the plan saves |
//! | `scenes`, `knobs`, `command` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod exercises;
pub mod facing;
pub mod hard;
pub mod iteration;
pub mod limits;
pub mod material;
pub mod mirror;
pub mod mtl;
pub mod naive;
pub mod picture;
pub mod recursion;
pub mod scatter;
pub mod tree;
pub mod world;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;
