//! BX-07 and X-01: NaN among the points, and what min and max make of it.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::draw;
use crate::aabb::Aabb;
use crate::naive;
use crate::slab::BoxRay;

/// Up to eight points, of which one has a coordinate that is NaN, and one may be infinite.
fn points(trial: u64) -> Vec<Vec3> {
    let mut stream = Stream::of_trial(851, trial);
    let count = 2 + draw::below(&mut stream, 7);
    let mut points: Vec<Vec3> = (0..count).map(|_| draw::point(&mut stream, 2.0)).collect();
    let [bad, other] = [draw::below(&mut stream, count), draw::below(&mut stream, count)];
    if trial.is_multiple_of(2) {
        points[other][draw::below(&mut stream, 3)] = f32::INFINITY * draw::sign(&mut stream);
    }
    points[bad][draw::below(&mut stream, 3)] = f32::NAN;
    points
}

/// Whether the box is anything but the smallest around the finite points, or is lost to rays at it.
fn is_wrong(points: &[Vec3], bounds: &Aabb) -> bool {
    let finite: Vec<Vec3> = points.iter().copied().filter(|point| point.is_finite()).collect();
    let origin = Vec3::new(20.0, -30.0, 40.0);
    let meets = |target: Vec3| {
        let ray = Ray { origin, direction: target - origin };
        BoxRay::new(&ray, bounds).enter(bounds, f32::INFINITY).is_some()
    };
    let tight = (0..3).all(|axis| {
        finite.iter().any(|point| point[axis] == bounds.min[axis])
            && finite.iter().any(|point| point[axis] == bounds.max[axis])
    });
    match finite[..] {
        [] => meets(Vec3::ZERO) || !bounds.is_empty(),
        _ => !tight || !finite.iter().all(|&point| bounds.contains(point) && meets(point)),
    }
}

pub(super) fn naive(trial: u64) -> bool {
    let points = points(trial);
    is_wrong(&points, &naive::of_points(&points))
}

pub(super) fn robust(trial: u64) -> bool {
    let points = points(trial);
    is_wrong(&points, &Aabb::of_points(points.iter().copied()))
}

/// Each coordinate of a box, in either of the two that are joined.
pub(super) const ORDERS: u64 = 12;

/// Two boxes, one of which has a NaN somewhere: the joined coordinate must be the other's.
fn order(trial: u64, join: fn(Aabb, Aabb) -> Aabb) -> bool {
    let good = Aabb { min: Vec3::new(4.0, -7.0, 10.0), max: Vec3::new(5.0, -5.0, 13.0) };
    let mut bad = good;
    let axis = (trial % 3) as usize;
    let is_min = (trial / 3).is_multiple_of(2);
    *(if is_min { &mut bad.min[axis] } else { &mut bad.max[axis] }) = f32::NAN;
    (if trial / 6 == 0 { join(bad, good) } else { join(good, bad) }) != good
}

pub(super) fn order_naive(trial: u64) -> bool {
    order(trial, |a, b| Aabb { min: a.min.min(b.min), max: a.max.max(b.max) })
}

pub(super) fn order_robust(trial: u64) -> bool {
    order(trial, Aabb::union)
}

#[cfg(test)]
mod tests {
    use std::hint::black_box;

    use glam::Vec3;

    /// Hard case X-01, as it is: four orders, and two of them differ.
    #[test]
    fn what_min_makes_of_nan() {
        let nan = black_box(f32::NAN);
        assert_eq!((nan.min(1.0), 1.0_f32.min(nan)), (1.0, 1.0));
        assert_eq!(Vec3::splat(nan).min(Vec3::ONE), Vec3::ONE);
        assert!(Vec3::ONE.min(Vec3::splat(nan)).is_nan(), "the second, whatever it is");
    }
}
