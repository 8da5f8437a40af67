//! BX-01 and BX-02: rays in the plane of a face, and zeros with a minus.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::draw;
use crate::aabb::Aabb;
use crate::naive::{PlainRay, natural, smits};
use crate::slab::BoxRay;

/// Rays in the planes of one box's faces: 3 axes, 2 faces, 2 signs of the zero, 2 axes to travel
/// along, 2 ways to go.
pub(crate) const IN_PLANE: u64 = 48;

/// An ordinary box, a flat one, a tiny one, a huge one, and one far away.
const BOXES: [Aabb; 5] = [
    LOPSIDED,
    Aabb { min: Vec3::new(-1.0, 2.0, 7.0), max: Vec3::new(4.0, 5.0, 7.0) },
    Aabb { min: Vec3::new(1e-30, -3e-30, 0.0), max: Vec3::new(2e-30, -1e-30, 3e-30) },
    Aabb { min: Vec3::new(-1e15, -2e15, 3e14), max: Vec3::new(1e14, 2e15, 4e15) },
    Aabb { min: Vec3::new(1e6, -3e6, 2e6), max: Vec3::new(1_000_001.0, -2_999_998.0, 2_000_003.0) },
];

/// One wide, two high, three deep.
pub(crate) const LOPSIDED: Aabb =
    Aabb { min: Vec3::new(4.0, -7.0, 10.0), max: Vec3::new(5.0, -5.0, 13.0) };

/// Each of them in the plane, and moved out of it.
pub(super) const TABLE: u64 = 2 * IN_PLANE * BOXES.len() as u64;

pub(super) fn naive(trial: u64) -> bool {
    let (ray, bounds, expected) = entry(trial);
    natural(&PlainRay::from(&ray), &bounds, f32::INFINITY) != expected
}

pub(super) fn robust(trial: u64) -> bool {
    let (ray, bounds, expected) = entry(trial);
    BoxRay::new(&ray, &bounds).enter(&bounds, f32::INFINITY).is_some() != expected
}

fn entry(trial: u64) -> (Ray, Aabb, bool) {
    let bounds = BOXES[(trial / (2 * IN_PLANE)) as usize];
    let in_plane = trial.is_multiple_of(2);
    let out_by = if in_plane { 0.0 } else { 0.25 * bounds.size().max_element() };
    (in_plane_ray(&bounds, trial / 2 % IN_PLANE, out_by), bounds, in_plane)
}

/// The ray number `index` in the plane of a face, or beside the box by `out_by`. It starts outside
/// and passes over the middle of the face.
pub(crate) fn in_plane_ray(bounds: &Aabb, index: u64, out_by: f32) -> Ray {
    let digit = |place: u64| (index >> place) & 1 == 1;
    let axis = (index / 16) as usize;
    let along = (axis + if digit(0) { 1 } else { 2 }) % 3;
    let mut origin = bounds.center();
    origin[axis] = if digit(1) { bounds.max[axis] + out_by } else { bounds.min[axis] - out_by };
    let mut direction = Vec3::ZERO;
    direction[axis] = if digit(2) { -0.0 } else { 0.0 };
    direction[along] = if digit(3) { -1.0 } else { 1.0 };
    origin[along] -= 2.0 * bounds.size().max_element() * direction[along];
    Ray { origin, direction }
}

/// A ray with one or two zeros, and the same with all zeros positive.
pub(crate) fn with_zeros(trial: u64) -> (Ray, Ray, Aabb) {
    let mut stream = Stream::of_trial(812, trial);
    let bounds = Aabb::of_points([draw::point(&mut stream, 2.0), draw::point(&mut stream, 2.0)]);
    let target = draw::point_in(&mut stream, &bounds);
    let mut direction = draw::point(&mut stream, 1.0);
    let zeros = 1 + draw::below(&mut stream, 6);
    for axis in (0..3).filter(|axis| zeros >> axis & 1 == 1) {
        direction[axis] = 0.0_f32.copysign(draw::sign(&mut stream));
    }
    // Every other ray is aimed at the box, or away from it.
    let back = stream.between(-4.0, 8.0) * direction;
    let aside = if trial.is_multiple_of(2) { Vec3::ZERO } else { draw::point(&mut stream, 1.0) };
    let signed = Ray { origin: target - back + aside, direction };
    // The sum turns -0 into +0, and nothing else into anything else.
    (signed, Ray { direction: direction + Vec3::ZERO, ..signed }, bounds)
}

pub(super) fn zero_naive(trial: u64) -> bool {
    let (signed, positive, bounds) = with_zeros(trial);
    let met = |ray: &Ray| smits(&PlainRay::from(ray), &bounds, f32::INFINITY);
    met(&signed) != met(&positive)
}

pub(super) fn zero_robust(trial: u64) -> bool {
    let (signed, positive, bounds) = with_zeros(trial);
    let enter = |ray: &Ray| BoxRay::new(ray, &bounds).enter(&bounds, f32::INFINITY);
    enter(&signed) != enter(&positive) || draw::is_wrong(&signed, &bounds)
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::{BOXES, IN_PLANE, in_plane_ray};

    #[test]
    fn the_table_has_48_different_rays_all_on_a_face() {
        for bounds in BOXES {
            let rays = (0..IN_PLANE).map(|index| in_plane_ray(&bounds, index, 0.0));
            let bits = |ray: &super::Ray| {
                [ray.origin.to_array(), ray.direction.to_array()].map(|it| it.map(f32::to_bits))
            };
            let flat = bounds.size().min_element() == 0.0;
            let different: HashSet<_> = rays.clone().map(|ray| bits(&ray)).collect();
            assert_eq!(different.len(), if flat { 40 } else { 48 }, "{bounds:?}");
            for ray in rays {
                let zero = (0..3).filter(|&axis| ray.direction[axis] == 0.0);
                let on_face = |axis: usize| {
                    ray.origin[axis] == bounds.min[axis] || ray.origin[axis] == bounds.max[axis]
                };
                assert!(zero.clone().any(on_face) && zero.count() == 2);
            }
        }
    }
}
