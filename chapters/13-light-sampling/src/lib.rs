//! Chapter 13: looking for light where it comes from.
//!
//! A path comes upon a small lamp once in a long while. This chapter looks at the lamp instead, from
//! every surface the path comes by: at a point of it, chosen by chance, with a density that is known.
//! It builds on [`path_tracing`], whose paths stay as they are, on [`monte_carlo`] and on [`shadows`].
//!
//! ```text
//! cargo run --release -p light-sampling
//! cargo run --release -p light-sampling -- --lighting direction
//! cargo run --release -p light-sampling -- --scene sphere-light --lighting solid-angle
//! cargo run --release -p light-sampling -- --scene many-lights --lamps uniform
//! cargo run --release -p light-sampling -- cost
//! cargo run --release -p light-sampling -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`lamp`] | a triangle or a ball that glows, points of it, and their density |
//! | [`spherical`] | a triangle's solid angle, and directions spread evenly over it |
//! | [`lights`] | all lamps, and which of them is looked at |
//! | [`by_light`] | paths that look at lamps, and count no light twice |
//! | [`polygon`] | a triangle's light in closed form, to hold estimates against |
//! | [`naive`] | the textbook's formulas and the report's lines, which fail |
//! | [`hard`] | inputs on which they fail and ours don't |
//! | `cost` | what accuracy costs in time |
//! | `scenes`, `knobs`, `command` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod by_light;
pub mod exercises;
pub mod hard;
pub mod lamp;
pub mod lights;
pub mod naive;
pub mod polygon;
pub mod spherical;

#[cfg(test)]
mod tiles;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;
