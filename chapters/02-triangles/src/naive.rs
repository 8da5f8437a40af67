//! The textbook formulas that fail. They are kept as negative controls, and for the book to show.

mod bare;
mod moller_trumbore;
mod plucker;

use glam::Vec3;

pub use bare::BareShear;
pub use moller_trumbore::{EPSILON, MollerTrumbore, Unguarded};
pub use plucker::Plucker;

// ANCHOR: area
/// Whether the triangle has an area, as many renderers ask: by the length of the cross product.
///
/// Its square is of the fourth order in the triangle's size, and vanishes in `f32` for one of
/// 10^-12 units (hard case TR-09).
pub fn has_area([a, b, c]: &[Vec3; 3]) -> bool {
    (*b - *a).cross(*c - *a).length_squared() != 0.0
}
// ANCHOR_END: area

/// The triangle's normal from two edges, whichever they are (hard case TR-11).
pub fn geometric_normal([a, b, c]: &[Vec3; 3]) -> Vec3 {
    (*b - *a).cross(*c - *a).normalize()
}

// ANCHOR: vertex_normals
/// The mean of the normals around each vertex, where one triangle without area spoils all three of
/// its vertices (hard case TR-14).
pub fn vertex_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for triangle in triangles {
        let corners = triangle.map(|vertex| positions[vertex as usize]);
        let normal = geometric_normal(&corners);
        for vertex in triangle {
            sums[*vertex as usize] += normal;
        }
    }
    sums.into_iter().map(|sum| sum.normalize()).collect()
}
// ANCHOR_END: vertex_normals
