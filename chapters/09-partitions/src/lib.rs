//! Chapter 9: cut space into cells, and ask only the triangles of those that a ray passes.
//!
//! Four ways to cut: a grid of equal cells, an octree, a k-d tree, a BSP tree. All give the linear
//! scan's answer to the last bit, with a hundredth of its work. The chapter builds on
//! [`triangles`]: its watertight test is the one test at every leaf; and on [`boxes`], where a ray
//! got the width that it takes to lose nothing.
//!
//! ```text
//! cargo run --release -p partitions
//! cargo run --release -p partitions -- --accel kd --split median
//! cargo run --release -p partitions -- --accel grid --cells 8 --view work
//! cargo run --release -p partitions -- cost
//! cargo run --release -p partitions -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`accelerator`] | what all structures can do |
//! | [`leaf`] | the one test, and which of two hits is the nearer |
//! | [`scan`] | chapter 2's loop over all triangles, the reference |
//! | [`wide`] | a ray with a width, and which part of it is on which side of a plane |
//! | [`cells`] | which cell a coordinate is in, and how many cells there should be |
//! | [`march`] | from cell to cell |
//! | [`grid`] | equal cells |
//! | [`octree`] | cells cut in eight |
//! | [`plane_tree`], [`plant`] | trees of planes: walked, and built |
//! | [`kd`], [`median`], [`surface_area`] | planes across the axes, and where |
//! | [`bsp`] | planes in thirteen directions |
//! | [`indexed`] | a mesh with a structure, as a shape for any scene |
//! | [`heat`] | a picture of work |
//! | [`naive`] | the textbook's walks, which fail |
//! | [`hard`] | inputs on which they fail and ours don't |
//! | `cost` | what finding costs, in nanoseconds |
//! | `choice`, `command` | the program and its options |
//! | [`exercises`] | yours to write |

pub mod accelerator;
pub mod bsp;
pub mod cells;
pub mod exercises;
pub mod grid;
pub mod hard;
pub mod heat;
pub mod indexed;
pub mod kd;
pub mod leaf;
pub mod march;
pub mod median;
pub mod naive;
pub mod octree;
pub mod plane_tree;
pub mod plant;
pub mod scan;
pub mod surface_area;
pub mod wide;

#[cfg(feature = "native")]
pub mod choice;
#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
