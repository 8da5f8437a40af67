//! The textbook formulas that fail. They are kept as negative controls, and for the book to show.

mod centroid;
mod line;
mod poisoned;
mod split;
mod until_last;

pub use centroid::octree_by_centroids;
pub use line::{Stop, along_a_line};
pub use poisoned::bounds;
pub use split::{along_a_line_in_a_tree, without_width};
pub use until_last::cells_until_last;

// ANCHOR: index
/// The cell that a coordinate is in, as most programs find it: one past the last for the upper face
/// (hard case AC-09).
pub fn index(coordinate: f32, low: f32, high: f32, cells: i32) -> i32 {
    ((coordinate - low) / (high - low) * cells as f32).floor() as i32
}
// ANCHOR_END: index

// ANCHOR: middle
/// The middle of a cell, whose sum overflows for large coordinates (hard case AC-07).
pub fn middle(low: f32, high: f32) -> f32 {
    0.5 * (low + high)
}
// ANCHOR_END: middle
