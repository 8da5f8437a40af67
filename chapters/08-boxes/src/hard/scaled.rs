//! a scene twice as large is the same scene.

use common::sampler::Stream;
use ray_casting::ray::Ray;

use super::draw;
use crate::aabb::Aabb;
use crate::naive::{PlainRay, thickened};
use crate::slab::BoxRay;

/// A box 10^-6 to 10 thick, and a ray at it or past it.
fn scaled(trial: u64) -> (Ray, Aabb, f32) {
    let mut stream = Stream::of_trial(881, trial);
    let mut bounds =
        Aabb::of_points([draw::point(&mut stream, 2.0), draw::point(&mut stream, 2.0)]);
    let axis = draw::below(&mut stream, 3);
    bounds.max[axis] = bounds.min[axis] + draw::decade(&mut stream, -6.0, 1.0);
    let aside = draw::decade(&mut stream, -6.0, 0.0);
    let target = draw::point_in(&mut stream, &bounds) + draw::point(&mut stream, aside);
    let origin = draw::point(&mut stream, 5.0);
    let exponent = draw::below(&mut stream, 41) as i32 - 20;
    (Ray { origin, direction: target - origin }, bounds, draw::power_of_two(exponent))
}

fn differs<T: PartialEq>(trial: u64, ask: impl Fn(&Ray, &Aabb) -> T) -> bool {
    let (ray, bounds, scale) = scaled(trial);
    let larger = Ray { origin: ray.origin * scale, direction: ray.direction * scale };
    let box_of_it = Aabb { min: bounds.min * scale, max: bounds.max * scale };
    ask(&ray, &bounds) != ask(&larger, &box_of_it)
}

pub(super) fn naive(trial: u64) -> bool {
    differs(trial, |ray, bounds| thickened(&PlainRay::from(ray), bounds, f32::INFINITY))
}

pub(super) fn robust(trial: u64) -> bool {
    differs(trial, |ray, bounds| {
        BoxRay::new(ray, bounds).enter(bounds, f32::INFINITY).map(f32::to_bits)
    })
}
