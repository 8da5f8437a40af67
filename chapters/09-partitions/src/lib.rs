//! Chapter 9: cut space into cells, and ask only the triangles of those that a ray passes.

pub mod accelerator;
pub mod indexed;
pub mod leaf;
pub mod scan;
