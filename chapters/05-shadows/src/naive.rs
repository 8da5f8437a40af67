//! Where rays start that don't know their error, and a test of visibility with a fixed epsilon.
//!
//! They are kept to be looked at, and as the negative controls of the hard cases.

use blinn_phong::light::Light;
use common::tally::Tally;
use glam::Vec3;
use ray_casting::direction::unit;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape, nearest};

use crate::occluder::Occluder;
use crate::offset::Leave;
use crate::visibility::free;

// ANCHOR: epsilon
/// One ten-thousandth, of whatever unit the scene happens to be in.
pub const EPSILON: f32 = 1e-4;
// ANCHOR_END: epsilon

// ANCHOR: stay
/// No offset: the ray starts in the point itself.
pub fn stay(hit: &Hit, _direction: Vec3) -> Vec3 {
    hit.point
}
// ANCHOR_END: stay

// ANCHOR: fixed
/// A fixed step along the ray, which is what skipping all hits nearer than it comes to.
pub fn fixed(hit: &Hit, direction: Vec3) -> Vec3 {
    hit.point + EPSILON * unit(direction).unwrap_or(Vec3::ZERO)
}
// ANCHOR_END: fixed

// ANCHOR: normal
/// The same step along the surface's normal.
pub fn normal(hit: &Hit, direction: Vec3) -> Vec3 {
    hit.point + EPSILON * side(hit, direction)
}
// ANCHOR_END: normal

// ANCHOR: integer
/// So many floats further along the normal: 256 steps of the last bit where the normal runs along
/// an axis. Where the point is near the coordinates' zero, and floats lie dense, a fixed step.
///
/// Wächter and Binder, "A fast and robust method for avoiding self-intersection" (Ray Tracing Gems,
/// chapter 6, 2019).
#[inline]
pub fn integer(hit: &Hit, direction: Vec3) -> Vec3 {
    let normal = side(hit, direction);
    let step = |axis: usize| {
        let (place, along) = (hit.point[axis], normal[axis]);
        if place.abs() < 1.0 / 32.0 {
            return place + along / 65536.0;
        }
        let steps = (256.0 * along) as i32;
        let steps = if place < 0.0 { -steps } else { steps };
        f32::from_bits(place.to_bits().wrapping_add_signed(steps))
    };
    Vec3::new(step(0), step(1), step(2))
}
// ANCHOR_END: integer

/// The surface's own normal, on the side of `direction`.
fn side(hit: &Hit, direction: Vec3) -> Vec3 {
    if hit.geometric.dot(direction) >= 0.0 { hit.geometric } else { -hit.geometric }
}

/// Whether the lamp reaches the surface by a ray that starts where `leave` says.
pub fn reaches<T: Tally>(
    scene: &(impl Occluder + ?Sized),
    light: &Light,
    hit: &Hit,
    leave: Leave,
    tally: &mut T,
) -> bool {
    let (origin, direction, t_max) = match *light {
        Light::Point { position, .. } => {
            let origin = leave(hit, position - hit.point);
            (origin, position - origin, 1.0)
        }
        Light::Directional { toward, .. } => (leave(hit, toward), toward, f32::INFINITY),
    };
    free(scene, &Ray { origin, direction }, t_max, tally)
}

// ANCHOR: report
/// The report's test (§5.3): whether the nearest thing from `point` towards `target` is no nearer
/// than `target`, but for an EPSILON that has a unit.
pub fn report_visible<T: Tally>(
    shapes: &[Box<dyn Shape>],
    point: Vec3,
    target: Vec3,
    tally: &mut T,
) -> bool {
    let distance = (target - point).length();
    let ray = Ray { origin: point, direction: (target - point) / distance };
    let check = nearest(shapes, &ray, tally).map_or(f32::INFINITY, |found| found.hit.t);
    check - distance > -EPSILON
}
// ANCHOR_END: report
