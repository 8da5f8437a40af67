//! BX-04, BX-05, BX-06 and BX-08: flat and huge boxes, the ends of the interval, tiny directions.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::draw;
use super::in_plane::LOPSIDED;
use crate::aabb::Aabb;
use crate::naive::{Form, PlainRay, folded, old_weekend, pbrt_fast, safe_reciprocal};
use crate::oracle::Verdict;
use crate::slab::BoxRay;

/// Whether a form is wrong where `f64` leaves no doubt.
fn is_wrong(form: Form, ray: &Ray, bounds: &Aabb) -> bool {
    let met = form(&PlainRay::from(ray), bounds, f32::INFINITY);
    match draw::allowed(ray, bounds) {
        Verdict::Met => !met,
        Verdict::Missed => met,
        Verdict::Close => false,
    }
}

/// A box without thickness on one axis, and a ray at it or beside it.
fn flat(trial: u64) -> (Ray, Aabb) {
    let mut stream = Stream::of_trial(841, trial);
    let mut bounds =
        Aabb::of_points([draw::point(&mut stream, 2.0), draw::point(&mut stream, 2.0)]);
    let axis = draw::below(&mut stream, 3);
    bounds.max[axis] = bounds.min[axis];
    let target = draw::point_in(&mut stream, &bounds);
    let aside = if trial.is_multiple_of(2) { Vec3::ZERO } else { draw::point(&mut stream, 2.0) };
    let origin = draw::point(&mut stream, 5.0);
    (Ray { origin, direction: target + aside - origin }, bounds)
}

pub(super) fn flat_naive(trial: u64) -> bool {
    let (ray, bounds) = flat(trial);
    is_wrong(old_weekend, &ray, &bounds)
}

pub(super) fn flat_robust(trial: u64) -> bool {
    let (ray, bounds) = flat(trial);
    draw::is_wrong(&ray, &bounds)
}

/// Boxes of 10^15, and rays along an axis but for 10^-25: Imath's `testPerturbedRayBox`, from all
/// over the face and not from its middle alone.
fn huge(trial: u64) -> (Ray, Aabb) {
    let mut stream = Stream::of_trial(842, trial);
    let bounds = if trial.is_multiple_of(2) {
        Aabb { min: Vec3::splat(-1e15), max: Vec3::splat(1e15) }
    } else {
        Aabb { min: Vec3::new(-1e10, -2e10, -3e10), max: Vec3::new(5e15, 6e15, 7e15) }
    };
    let mut origin = draw::point_in(&mut stream, &bounds);
    let mut direction = draw::point(&mut stream, 1e-25);
    let axis = draw::below(&mut stream, 3);
    direction[axis] = draw::sign(&mut stream);
    origin[axis] = -2e16 * direction[axis];
    (Ray { origin, direction }, bounds)
}

pub(super) fn huge_naive(trial: u64) -> bool {
    let (ray, bounds) = huge(trial);
    is_wrong(folded, &ray, &bounds)
}

pub(super) fn huge_robust(trial: u64) -> bool {
    let (ray, bounds) = huge(trial);
    draw::is_wrong(&ray, &bounds)
}

/// A direction of any length from 10^-30 to 10^3, whose components differ by up to 45 decades.
fn tiny_direction(trial: u64) -> (Ray, Aabb) {
    let mut stream = Stream::of_trial(843, trial);
    let bounds = Aabb::of_points([draw::point(&mut stream, 2.0), draw::point(&mut stream, 2.0)]);
    let mut slope = Vec3::from([(); 3].map(|()| {
        let lowest = if stream.bits() & 1 == 0 { -45.0 } else { -3.0 };
        draw::decade(&mut stream, lowest, 0.0) * draw::sign(&mut stream)
    }));
    slope[draw::below(&mut stream, 3)] = draw::sign(&mut stream);
    let target = draw::point_in(&mut stream, &bounds);
    let aside = if trial.is_multiple_of(2) { Vec3::ZERO } else { draw::point(&mut stream, 1.0) };
    let origin = target + aside - stream.between(0.0, 9.0) * slope;
    (Ray { origin, direction: draw::decade(&mut stream, -30.0, 3.0) * slope }, bounds)
}

pub(super) fn tiny_naive(trial: u64) -> bool {
    let (ray, bounds) = tiny_direction(trial);
    is_wrong(safe_reciprocal, &ray, &bounds)
}

pub(super) fn tiny_robust(trial: u64) -> bool {
    let (ray, bounds) = tiny_direction(trial);
    draw::is_wrong(&ray, &bounds)
}

/// The ends of the interval, which belong to it. Each ray runs along -y, at the box's x and z.
struct End {
    /// The ray's y.
    y: f32,
    t_max: f32,
    met: bool,
}

const fn end(y: f32, t_max: f32, met: bool) -> End {
    End { y, t_max, met }
}

/// The box reaches from y = -7 to y = -5.
const ENDS: [End; 14] = [
    // Inside; on the face it enters by; on the face it leaves by.
    end(-6.0, f32::INFINITY, true),
    end(-6.0, 0.0, true),
    end(-5.0, f32::INFINITY, true),
    end(-5.0, 0.0, true),
    end(-7.0, f32::INFINITY, true),
    end(-7.0, 0.0, true),
    // Before it: the end of the ray short of the box, at it, in it.
    end(3.0, 7.9, false),
    end(3.0, 8.0, true),
    end(3.0, 9.0, true),
    // Behind it.
    end(-7.1, f32::INFINITY, false),
    end(-40.0, f32::INFINITY, false),
    // No interval at all.
    end(-6.0, -1.0, false),
    end(3.0, f32::NEG_INFINITY, false),
    end(-6.0, f32::NAN, false),
];

/// Each end from the middle, an edge and a corner of the box.
pub(super) const ENDS_COUNT: u64 = 3 * ENDS.len() as u64;

fn end_at(trial: u64) -> (Ray, &'static End) {
    let end = &ENDS[(trial / 3) as usize];
    let middle = LOPSIDED.center();
    let (x, z) = match trial % 3 {
        0 => (middle.x, middle.z),
        1 => (middle.x, LOPSIDED.max.z),
        _ => (LOPSIDED.min.x, LOPSIDED.max.z),
    };
    (Ray { origin: Vec3::new(x, end.y, z), direction: Vec3::NEG_Y }, end)
}

pub(super) fn end_naive(trial: u64) -> bool {
    let (ray, end) = end_at(trial);
    pbrt_fast(&PlainRay::from(&ray), &LOPSIDED, end.t_max) != end.met
}

pub(super) fn end_robust(trial: u64) -> bool {
    let (ray, end) = end_at(trial);
    BoxRay::new(&ray, &LOPSIDED).enter(&LOPSIDED, end.t_max).is_some() != end.met
}
