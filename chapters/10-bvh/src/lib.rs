//! Chapter 10: bounding volume hierarchies.
//!
//! Chapter 9 divides space, and a triangle may lie in many cells. Here the triangles are divided:
//! each is in one leaf, a box is drawn around each set, and boxes may overlap. A ray that misses a box
//! misses all that is in it. This chapter builds on [`boxes`], on the seam of [`partitions`] that all
//! structures share, and draws the lit scenes of [`shadows`].
//!
//! ```text
//! cargo run --release -p bvh
//! cargo run --release -p bvh -- headline
//! cargo run --release -p bvh -- --view work --traversal both
//! cargo run --release -p bvh -- --view cut --split median
//! cargo run --release -p bvh -- --scene sphere:1000000 --accel bvh
//! cargo run --release -p bvh -- cost
//! cargo run --release -p bvh -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`node`], [`tree`] | a tree of boxes, flat in a list |
//! | [`split`] | where to cut a set in two: the middle, the median, by surface area |
//! | [`build`] | from boxes to a tree of known depth, whatever the boxes are |
//! | [`quality`] | the work a tree promises, before the first ray |
//! | [`plain`] | the report's traversal, and one that goes to the nearer child first |
//! | [`packed`] | two boxes and four triangles at once |
//! | [`seam`] | what later chapters make their meshes into |
//! | [`naive`] | the textbook's lines, which fail |
//! | [`hard`] | inputs on which they fail and ours don't |
//! | `cost` | what a better tree costs and saves, and how time grows |
//! | `cut` | a picture of the tree itself |
//! | `headline` | the report's two numbers, measured again |
//! | `choice`, `knobs`, `stage`, `command` | the program and its options |
//! | [`exercises`] | yours to write |

mod bins;
pub mod build;
pub mod exercises;
pub mod hard;
mod item;
pub mod naive;
pub mod node;
pub mod packed;
mod pairs;
pub mod plain;
pub mod quality;
pub mod seam;
pub mod split;
pub mod tree;

#[cfg(feature = "native")]
pub mod choice;
#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod cut;
#[cfg(feature = "native")]
pub mod headline;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod stage;
