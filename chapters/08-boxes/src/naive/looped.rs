//! Forms that know from the direction which face comes first, and may give up early.

use std::mem::swap;

use ray_casting::rounding::gamma;

use super::PlainRay;
use super::compared::{higher, lower};
use crate::aabb::Aabb;

/// Kay and Kajiya, "Ray Tracing Complex Scenes" (SIGGRAPH 1986): a ray beside the slab is a case of
/// its own. Right on rays in a face's plane, at the price of a question and a division an axis.
pub fn kay_kajiya(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let (mut enter, mut leave) = (0.0, t_max);
    for axis in 0..3 {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        if d == 0.0 {
            if o < bounds.min[axis] || o > bounds.max[axis] {
                return false;
            }
            continue;
        }
        let (mut near, mut far) = ((bounds.min[axis] - o) / d, (bounds.max[axis] - o) / d);
        if near > far {
            swap(&mut near, &mut far);
        }
        enter = higher(near, enter);
        leave = lower(far, leave);
        if enter > leave {
            return false;
        }
    }
    true
}

// ANCHOR: smits
/// Smits, "Efficiency Issues for Ray Tracing" (Journal of Graphics Tools 3(2), 1998): the direction's
/// sign says which face comes first. But -0 is not below 0, while its reciprocal is -∞.
pub fn smits(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let (mut enter, mut leave) = (0.0, t_max);
    for axis in 0..3 {
        let (low, high) = (bounds.min[axis], bounds.max[axis]);
        let (near, far) = if ray.direction[axis] >= 0.0 { (low, high) } else { (high, low) };
        enter = higher((near - ray.origin[axis]) * ray.inverse[axis], enter);
        leave = lower((far - ray.origin[axis]) * ray.inverse[axis], leave);
    }
    enter <= leave
}
// ANCHOR_END: smits

// ANCHOR: old_weekend
/// "Ray Tracing: The Next Week", before it thickened its boxes. An interval that is one point counts as empty,
/// so that a box without thickness is never met (hard case BX-04).
pub fn old_weekend(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let (mut enter, mut leave) = (0.0, t_max);
    for axis in 0..3 {
        let mut near = (bounds.min[axis] - ray.origin[axis]) * ray.inverse[axis];
        let mut far = (bounds.max[axis] - ray.origin[axis]) * ray.inverse[axis];
        if ray.inverse[axis] < 0.0 {
            swap(&mut near, &mut far);
        }
        enter = if near > enter { near } else { enter };
        leave = if far < leave { far } else { leave };
        if leave <= enter {
            return false;
        }
    }
    true
}
// ANCHOR_END: old_weekend

/// Pharr, Jakob and Humphreys, "Physically Based Rendering" (4th edition, 2023), section 6.1.2: the
/// loop, with Ize's factor on the far face.
pub fn pbrt_loop(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let (mut enter, mut leave) = (0.0, t_max);
    for axis in 0..3 {
        let mut near = (bounds.min[axis] - ray.origin[axis]) * ray.inverse[axis];
        let mut far = (bounds.max[axis] - ray.origin[axis]) * ray.inverse[axis];
        if near > far {
            swap(&mut near, &mut far);
        }
        far *= 1.0 + 2.0 * gamma(3);
        enter = if near > enter { near } else { enter };
        leave = if far < leave { far } else { leave };
        if enter > leave {
            return false;
        }
    }
    true
}

/// The same book's form for trees, with the signs known beforehand (after Williams, Barrus, Morley
/// and Shirley, "An Efficient and Robust Ray-Box Intersection Algorithm", 2005). NaN on the x axis
/// stays.
pub fn pbrt_fast(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let faces = |axis: usize| {
        let (low, high) = (bounds.min[axis], bounds.max[axis]);
        let (near, far) = if ray.inverse[axis] < 0.0 { (high, low) } else { (low, high) };
        let near = (near - ray.origin[axis]) * ray.inverse[axis];
        (near, (far - ray.origin[axis]) * ray.inverse[axis] * (1.0 + 2.0 * gamma(3)))
    };
    let (mut enter, mut leave) = faces(0);
    for axis in [1, 2] {
        let (near, far) = faces(axis);
        if enter > far || near > leave {
            return false;
        }
        enter = if near > enter { near } else { enter };
        leave = if far < leave { far } else { leave };
    }
    enter < t_max && leave > 0.0
}
