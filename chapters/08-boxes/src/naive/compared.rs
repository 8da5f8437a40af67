//! Forms that sort the two faces by comparing their distances.

use super::PlainRay;
use crate::aabb::Aabb;

// ANCHOR: natural
/// As one would write it in Rust. `f32::min` and `f32::max` pass over a NaN, and so give the other
/// face's infinity to both: a ray in the plane of a face is never inside.
pub fn natural(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let (mut enter, mut leave) = (0.0_f32, t_max);
    for axis in 0..3 {
        let a = (bounds.min[axis] - ray.origin[axis]) * ray.inverse[axis];
        let b = (bounds.max[axis] - ray.origin[axis]) * ray.inverse[axis];
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    enter <= leave
}
// ANCHOR_END: natural

/// The same with glam's vectors, whose minimum is that of the processor: of two numbers of which one
/// is NaN the second. So it depends on which face the NaN belongs to.
pub fn glam_vectors(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let a = (bounds.min - ray.origin) * ray.inverse;
    let b = (bounds.max - ray.origin) * ray.inverse;
    let enter = a.min(b).max_element().max(0.0);
    let leave = a.max(b).min_element().min(t_max);
    enter <= leave
}

/// Tavian Barnes, "Fast, Branchless Ray/Bounding Box Intersections, Part 2: NaNs" (2015). Here the box
/// doesn't own its faces: a ray in the plane of one is a miss, on purpose and always.
pub fn tavian_2015(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let faces = |axis: usize| {
        let a = (bounds.min[axis] - ray.origin[axis]) * ray.inverse[axis];
        let b = (bounds.max[axis] - ray.origin[axis]) * ray.inverse[axis];
        (a, b)
    };
    let (a, b) = faces(0);
    let (mut enter, mut leave) = (lower(a, b), higher(a, b));
    for axis in [1, 2] {
        let (a, b) = faces(axis);
        enter = higher(enter, lower(lower(a, b), leave));
        leave = lower(leave, higher(higher(a, b), enter));
    }
    leave > higher(enter, 0.0) && enter <= t_max
}

// ANCHOR: tavian_2022
/// The same author's "Part 3: Boundaries" (2022): each face alone is held against the interval so
/// far, and NaN loses. Right on every ray in a face's plane, but without a margin (hard case BX-03).
pub fn tavian_2022(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let (mut enter, mut leave) = (0.0, t_max);
    for axis in 0..3 {
        let a = (bounds.min[axis] - ray.origin[axis]) * ray.inverse[axis];
        let b = (bounds.max[axis] - ray.origin[axis]) * ray.inverse[axis];
        (enter, leave) =
            (lower(higher(a, enter), higher(b, enter)), higher(lower(a, leave), lower(b, leave)));
    }
    enter <= leave
}
// ANCHOR_END: tavian_2022

// ANCHOR: lower
/// The lower of two; the second where one is NaN. One instruction, which `f32::min` is not.
pub(super) fn lower(x: f32, y: f32) -> f32 {
    if x < y { x } else { y }
}

/// The higher of two; the second where one is NaN.
pub(super) fn higher(x: f32, y: f32) -> f32 {
    if x > y { x } else { y }
}
// ANCHOR_END: lower
