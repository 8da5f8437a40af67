//! Chapter 6: mirrors, and rays that are followed from mirror to mirror.
//!
//! | module | idea |
//! |---|---|
//! | [`scatter`] | the seam between what is followed and what it meets |
//! | [`limits`] | which branches are worth following |
//! | [`recursion`] | following them by a function that calls itself |
//! | [`iteration`] | the same as a loop with a list of what is left to do |
//! | [`mirror`] | the ray that leaves a mirror |
//! | [`material`] | a surface that also reflects |

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
