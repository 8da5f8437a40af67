//! Warps: from uniform points of the unit square to points of other places, with their densities.
//!
//! Each takes a point u with both coordinates in [0, 1), and never rejects one.

pub mod cap;
pub mod disk;
pub mod hemisphere;
pub mod sphere;
pub mod triangle;

#[cfg(test)]
mod tests;
