//! Chapter 9: cut space into cells, and ask only the triangles of those that a ray passes.

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
