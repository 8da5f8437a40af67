//! Where a ray that leaves a surface has to start.

use glam::Vec3;
use ray_casting::shape::Hit;

// ANCHOR: spawn
/// The origin of a ray that leaves the surface at `hit` on the side of `direction`, whatever that
/// one's length.
///
/// Pharr, Jakob and Humphreys, "Physically Based Rendering" (fourth edition, 2023), section 6.8.6.
pub fn spawn(hit: &Hit, direction: Vec3) -> Vec3 {
    leave(hit, direction, reach(hit))
}

/// How far from its point, along its normal, the surface at `hit` may be.
fn reach(hit: &Hit) -> f32 {
    hit.geometric.abs().dot(hit.error)
}
// ANCHOR_END: spawn

/// The same for a surface that is asked from `distance` away, an upper bound of it.
///
/// Shapes know their own error for rays that start beside them. The longer the way, the more is
/// rounded: at most 32 roundings of the distance, and for a sphere as many of its radius, of which
/// `hit.error` has seven. A plane needs four and a triangle six.
pub(crate) fn spawn_far(hit: &Hit, direction: Vec3, distance: f32) -> Vec3 {
    leave(hit, direction, 5.0 * reach(hit) + ray_casting::rounding::gamma(32) * distance)
}

// ANCHOR: leave
/// The point of `hit`, moved `distance` along the surface's own normal to the side of `direction`.
fn leave(hit: &Hit, direction: Vec3, distance: f32) -> Vec3 {
    let outward = hit.geometric.dot(direction) >= 0.0;
    let offset = if outward { distance } else { -distance } * hit.geometric;
    let moved = hit.point + offset;
    let away = |axis: usize| match offset[axis] {
        // The sum was rounded, maybe backwards; one step further it is not.
        step if step > 0.0 => moved[axis].next_up(),
        step if step < 0.0 => moved[axis].next_down(),
        _ => moved[axis],
    };
    Vec3::new(away(0), away(1), away(2))
}
// ANCHOR_END: leave
