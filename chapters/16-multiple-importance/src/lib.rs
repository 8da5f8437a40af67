//! Chapter 16: several ways to look for light, and the weights that let them share.
//!
//! A small lamp is found by looking at it, a polished surface's reflection by following it. Where
//! both can find the same light, each counts a part of it, and the parts add up to 1. This chapter
//! builds on [`path_tracing`], on the lamps of [`light_sampling`], on the metal of [`microfacets`],
//! and on the paths of [`russian_roulette`], and adds one trait implementation: [`combined`].
//!
//! ```text
//! cargo run --release -p multiple-importance
//! cargo run --release -p multiple-importance -- --lighting light
//! cargo run --release -p multiple-importance -- --lighting direction
//! cargo run --release -p multiple-importance -- --scene cornell
//! cargo run --release -p multiple-importance -- --scene cornell --reuse 4
//! cargo run --release -p multiple-importance -- cost
//! cargo run --release -p multiple-importance -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`heuristic`] | weights that add up to 1, whatever the densities |
//! | [`combined`] | light that is looked for in both ways |
//! | [`half`] | what each of the two ways brings to it |
//! | [`reuse`] | paths that neighbouring pixels share |
//! | [`place`] | a lobe and a lamp with a closed form, to try estimators on |
//! | [`plates`] | the scene that shows what each strategy is good for |
//! | [`naive`] | the textbook's formulas, which fail, and estimators that are wrong |
//! | [`hard`] | inputs on which the naive formulas fail and ours don't |
//! | `cost` | what accuracy costs in time |
//! | `scenes`, `knobs`, `command` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod combined;
pub mod exercises;
pub mod half;
pub mod hard;
pub mod heuristic;
pub mod naive;
pub mod place;
pub mod plates;
pub mod reuse;

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
