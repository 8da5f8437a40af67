//! Chapter 11: integrals by chance, and how wrong chance is.
//!
//! Light arrives from all directions, and its sum is an integral that no formula solves. This chapter
//! estimates integrals as means of random samples, says how far off such a mean is, and makes it less
//! so: by choosing where samples fall, and by spreading them evenly. There are no rays here; all that
//! is built on is [`common`]. The chapters that follow light are built on this one.
//!
//! ```text
//! cargo run --release -p monte-carlo
//! cargo run --release -p monte-carlo -- --scene warps --points random
//! cargo run --release -p monte-carlo -- --scene convergence
//! cargo run --release -p monte-carlo -- cost
//! cargo run --release -p monte-carlo -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`estimator`] | an integral as the mean of values over densities |
//! | [`sky`] | an integral with a known answer: the light of a cloudy sky |
//! | [`power`] | densities to choose from, by inversion; some make it worse |
//! | [`warp`] | from the unit square to disks, hemispheres, spheres, caps and triangles |
//! | [`frame`] | axes around a direction |
//! | [`table`] | choosing one of many, as often as their weights say |
//! | [`strata`], [`sobol`] | points spread more evenly than chance would |
//! | [`points`] | the three kinds of points, to choose from |
//! | [`convergence`] | how fast an error falls |
//! | [`fit`] | whether samples follow the density they claim |
//! | [`angle`] | the angle between two directions, without an arc cosine |
//! | [`naive`] | the textbook's formulas, which fail |
//! | [`hard`] | inputs on which the naive formulas fail and ours don't |
//! | `cost` | what accuracy costs in time |
//! | `picture`, `chart`, `knobs`, `command` | the program, its pictures and options |
//! | [`exercises`] | yours to write |

pub mod angle;
pub mod convergence;
pub mod estimator;
pub mod exercises;
pub mod fit;
pub mod frame;
pub mod hard;
pub mod naive;
pub mod points;
pub mod power;
pub mod sky;
pub mod sobol;
pub mod strata;
pub mod table;
pub mod warp;

#[cfg(feature = "native")]
pub mod chart;
#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod picture;
