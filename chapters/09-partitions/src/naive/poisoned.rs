//! A box around everything, good and bad.

use boxes::aabb::Aabb;
use glam::Vec3;

// ANCHOR: poisoned
/// The box around all corners by `Vec3::min` and `Vec3::max`, which let NaN through or not as their
/// arguments come (hard case AC-05).
pub fn bounds(triangles: &[[Vec3; 3]]) -> Aabb {
    let corners = triangles.iter().flatten();
    corners.fold(Aabb { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY }, |all, &corner| Aabb {
        min: all.min.min(corner),
        max: all.max.max(corner),
    })
}
// ANCHOR_END: poisoned
