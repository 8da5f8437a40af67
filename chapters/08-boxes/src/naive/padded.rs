//! Forms with a margin of the wrong kind, or none where it is needed.

use glam::Vec3;
use ray_casting::rounding::gamma;

use super::PlainRay;
use super::compared::{higher, lower, natural, tavian_2022};
use crate::aabb::Aabb;

// ANCHOR: ize
/// [`tavian_2022`] with Ize's factor, which covers this test's own roundings, and no others.
pub fn ize(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let (mut enter, mut leave) = (0.0, t_max);
    let wider = 1.0 + 2.0 * gamma(3);
    for axis in 0..3 {
        let a = (bounds.min[axis] - ray.origin[axis]) * ray.inverse[axis];
        let b = (bounds.max[axis] - ray.origin[axis]) * ray.inverse[axis];
        (enter, leave) = (
            lower(higher(a, enter), higher(b, enter)),
            higher(lower(a * wider, leave), lower(b * wider, leave)),
        );
    }
    enter <= leave
}
// ANCHOR_END: ize

// ANCHOR: folded
/// One multiplication and one subtraction a face, for processors that have both in one instruction.
/// For rays along an axis it subtracts infinities (hard case BX-05).
pub fn folded(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let start = ray.origin * ray.inverse;
    let a = bounds.min * ray.inverse - start;
    let b = bounds.max * ray.inverse - start;
    let (near, far) = (a.min(b), a.max(b));
    near.max_element().max(0.0) <= far.min_element().min(t_max)
}
// ANCHOR_END: folded

// ANCHOR: safe
/// [`tavian_2022`] with a "safe" reciprocal: a component below 1e-12 is replaced by 1e-12. The
/// number has the unit of the direction, whose length nobody promised (hard case BX-08).
pub fn safe_reciprocal(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let safe = |component: f32| 1.0 / component.abs().max(1e-12).copysign(component);
    let inverse = Vec3::from(ray.direction.to_array().map(safe));
    tavian_2022(&PlainRay { inverse, ..*ray }, bounds, t_max)
}
// ANCHOR_END: safe

// ANCHOR: thickened
/// [`natural`] for a box that is made at least 0.0001 thick, as "Ray Tracing: The Next Week" does it:
/// a length with a unit that no scene promised (hard case X-08).
pub fn thickened(ray: &PlainRay, bounds: &Aabb, t_max: f32) -> bool {
    let missing = (Vec3::splat(1e-4) - bounds.size()).max(Vec3::ZERO);
    let bounds = Aabb { min: bounds.min - 0.5 * missing, max: bounds.max + 0.5 * missing };
    natural(ray, &bounds, t_max)
}
// ANCHOR_END: thickened
