//! Uniform points of a triangle.

use glam::{Vec2, Vec3};

// ANCHOR: triangle
/// The weights of the three corners: each at least 0, and 1 together, for uniform points.
///
/// A line at a part s of the height has a length in proportion to 1 - s, so s is 1 - √u; the place
/// on the line is uniform. Turk, "Generating random points in triangles" (Graphics Gems, 1990).
#[inline]
pub fn barycentric(u: Vec2) -> Vec3 {
    let root = u.x.sqrt();
    let third = u.y * root;
    Vec3::new(1.0 - root, root - third, third)
}
// ANCHOR_END: triangle
