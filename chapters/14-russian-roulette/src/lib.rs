//! Chapter 14: paths that end by chance, and are right on average.

pub mod naive;
pub mod roulette;
