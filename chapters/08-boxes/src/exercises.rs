//! Yours to write. Each function is an exercise of the chapter's page; replace its body.
//!
//! ```text
//! cargo test -p boxes --test exercises
//! ```

use glam::Vec3;
use ray_casting::ray::Ray;

use crate::aabb::Aabb;

/// Exercise 8.1: the smallest box around points.
///
/// A point with a coordinate that is NaN or infinite does not count: leave out the whole point. None
/// when no point is left. The points may lie anywhere, all of them far below 0 too.
///
/// See "The smallest box" on the chapter's page.
pub fn smallest_box(points: &[Vec3]) -> Option<Aabb> {
    let _ = points;
    todo!("exercise 8.1")
}

/// Exercise 8.2: the area of a box's six faces.
///
/// It must be right to 1 in 10^6, and 0 for a box that is empty: one whose `min` is above its `max`
/// on some axis.
///
/// See "Large faces are met more often" on the chapter's page.
pub fn surface_area(bounds: &Aabb) -> f32 {
    let _ = bounds;
    todo!("exercise 8.2")
}

/// Exercise 8.3: where a ray enters a box, in lengths of its direction.
///
/// 0 when the ray starts in the box. None when the box is not met between 0 and `t_max`. No
/// component of the direction is 0 here, and each may have either sign. The distance must be right
/// to 1 in 10^4. Padding is not asked for.
///
/// See "Three slabs" on the chapter's page.
pub fn enter(ray: &Ray, bounds: &Aabb, t_max: f32) -> Option<f32> {
    let _ = (ray, bounds, t_max);
    todo!("exercise 8.3")
}

/// Exercise 8.4, find the mistake: whether a ray meets a box, for rays and boxes that are flat.
///
/// `naive::old_weekend` is the published line. It is wrong about boxes without thickness. Yours must
/// be right about those, about rays that run in the plane of a face (they meet the box), and about
/// zeros of either sign in the direction. The box may be of any size. Rays that come near it without
/// touching it are misses.
///
/// See "Rays in the plane of a face" on the chapter's page.
pub fn meets(ray: &Ray, bounds: &Aabb) -> bool {
    let _ = (ray, bounds);
    todo!("exercise 8.4")
}

/// Exercise 8.5: how far the faces of all boxes of a scene are moved outward for a ray.
///
/// It is 16 u, with u = 2⁻²⁴, times the largest distance along any axis between the ray's `origin`
/// and a corner of `scene`. It must be right to 1 in 10^5.
///
/// See "A pad with a unit" on the chapter's page.
pub fn pad(origin: Vec3, scene: &Aabb) -> f32 {
    let _ = (origin, scene);
    todo!("exercise 8.5")
}
