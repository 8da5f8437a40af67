//! Yours to write. Each function is an exercise of the chapter's page; replace its body.
//!
//! ```text
//! cargo test -p triangles --test exercises
//! ```

use glam::{Vec2, Vec3};

/// Exercise 2.1: on which side of the origin does the line from `p` to `q` pass?
///
/// Positive when the origin is to the left of somebody who walks from `p` to `q`, negative when it
/// is to the right, and 0 when it is exactly on the line: twice the signed area of the triangle
/// (0, p, q). The sign must be right for any finite `f32` input, and the value right to 15 digits.
///
/// See "The edge function" on the chapter's page.
pub fn edge_function(p: Vec2, q: Vec2) -> f64 {
    let _ = (p, q);
    todo!("exercise 2.1")
}

/// Exercise 2.2: Möller and Trumbore's test, without its epsilon.
///
/// The distance t, in lengths of `direction`, at which the ray from `origin` hits the triangle with
/// these corners; None if it misses it or would have to go back (t must be above 0). Both sides of
/// the triangle can be hit. The triangle may be as small as 10^-9 across.
///
/// See "Three unknowns" on the chapter's page.
pub fn intersect(origin: Vec3, direction: Vec3, corners: [Vec3; 3]) -> Option<f32> {
    let _ = (origin, direction, corners);
    todo!("exercise 2.2")
}

/// Exercise 2.3: the smooth normal at a hit.
///
/// The mean of the three corners' normals with the barycentric weights of a, b and c, scaled to
/// length 1. Where the corners' normals cancel (the mean is shorter than 0.0001), the triangle's own
/// normal `geometric`.
///
/// See "Smooth normals" on the chapter's page.
pub fn smooth_normal(normals: [Vec3; 3], weights: Vec3, geometric: Vec3) -> Vec3 {
    let _ = (normals, weights, geometric);
    todo!("exercise 2.3")
}

/// Exercise 2.4: find the mistake.
///
/// This is how many renderers ask whether a triangle has an area:
///
/// ```text
/// let [a, b, c] = corners;
/// (b - a).cross(c - a).length_squared() != 0.0
/// ```
///
/// It throws away triangles that can be seen. Write it so that it is right for triangles from
/// 10^-30 to 10^30 across: true exactly when the corners are not in line. In the tests they are
/// either far from in line, or in line to the last bit. So `f64` is enough here. The chapter's own
/// `has_area` does more, for corners that are nearly in line: there `f64` rounds, too.
///
/// See "Triangles without area" on the chapter's page.
pub fn has_area(corners: [Vec3; 3]) -> bool {
    let _ = corners;
    todo!("exercise 2.4")
}

/// Exercise 2.5: is this mesh closed?
///
/// True when each edge of each triangle has exactly one partner: an edge of another triangle that
/// runs between the same two vertices the other way. The chapter's `edges_without_partner` asks for
/// less: it lets an edge have two partners if there are as many one way as the other. Three numbers a triangle, as in
/// [`Mesh`](crate::mesh::Mesh). A mesh without triangles is closed.
///
/// See "Watertight" on the chapter's page.
pub fn is_closed(triangles: &[[u32; 3]]) -> bool {
    let _ = triangles;
    todo!("exercise 2.5")
}
