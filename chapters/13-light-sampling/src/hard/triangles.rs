//! LS-03 and LS-04: the solid angle of a triangle, and the weights of a point of it.

use std::f32::consts::TAU;

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{DVec3, Vec2, Vec3};
use triangles::surface::{area_vector, between};

use super::{CHAPTER, decades, direction, point};
use crate::naive;
use crate::spherical::Spherical;

/// LS-03: triangles from near to a million times their size away.
pub(super) const SOLID_ANGLE: Case = Case {
    id: "LS-03",
    chapter: CHAPTER,
    input: "the solid angle of a triangle, 10^-13 to 2 pi, to 3 in 100,000",
    most: UNLIMITED,
    naive_fails: |trial| {
        let View { corners, from } = View::of(trial);
        is_far_from(&corners, from, naive::girard(&corners, from))
    },
    robust_fails: |trial| {
        let View { corners, from } = View::of(trial);
        let seen = Spherical::new(&corners, area_vector(&corners), from);
        is_far_from(&corners, from, seen.solid_angle())
    },
};

/// A triangle, and where it is seen from.
struct View {
    corners: [Vec3; 3],
    from: Vec3,
}

impl View {
    fn of(trial: u64) -> Self {
        let mut stream = Stream::of_trial(1333, trial);
        let corners = [(); 3].map(|()| point(&mut stream));
        let from = decades(&mut stream, -0.5, 6.0) * direction(&mut stream);
        let view = Self { corners, from };
        let smallest = 1e-2 * area_vector(&corners).length();
        let height = (corners[0] - from).as_dvec3().dot(area_vector(&corners)).abs();
        // Slivers, and an eye in the lamp's plane, have a case of their own.
        if smallest > 1e-4 && height > smallest { view } else { Self::of(trial + (1 << 40)) }
    }
}

fn is_far_from(corners: &[Vec3; 3], from: Vec3, found: f32) -> bool {
    let right = by_definition(corners.map(|corner| corner.as_dvec3() - from.as_dvec3()));
    if !(1e-13..=f64::from(TAU) - 1e-3).contains(&right) {
        return false;
    }
    !((f64::from(found) / right - 1.0).abs() <= 3e-5)
}

/// The integral of cos θ' / distance² over the triangle, seen from the origin: in pieces that are
/// small against their distance, each by a rule of seven points.
fn by_definition(corners: [DVec3; 3]) -> f64 {
    let [a, b, c] = corners;
    let center = (a + b + c) / 3.0;
    let widest = [b - a, c - b, a - c].map(DVec3::length).into_iter().fold(0.0, f64::max);
    if widest > 0.25 * center.length() {
        let [ab, bc, ca] = [(a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0];
        let parts = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
        return parts.into_iter().map(by_definition).sum();
    }
    let across = (b - a).cross(c - a);
    let at = |weights: [f64; 3]| {
        let point = weights[0] * a + weights[1] * b + weights[2] * c;
        let distance = point.length();
        1.0 / (distance * distance * distance)
    };
    let turned = |one: f64| {
        let other = (1.0 - one) / 2.0;
        at([one, other, other]) + at([other, one, other]) + at([other, other, one])
    };
    let mean = 0.225 * at([1.0 / 3.0; 3])
        + 0.132_394_152_788_506_2 * turned(0.059_715_871_789_769_82)
        + 0.125_939_180_544_827_2 * turned(0.797_426_985_353_087_3);
    // Twice the area times the plane's distance, which all points share.
    a.dot(across).abs() * mean / 2.0
}

/// LS-04: points on the edge of a lamp.
pub(super) const WEIGHTS: Case = Case {
    id: "LS-04",
    chapter: CHAPTER,
    input: "weights of points at a lamp's edge: at least 0, and 1 together",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (View { corners, from }, u) = at_edge(trial);
        let seen = Spherical::new(&corners, area_vector(&corners), from);
        let way = between(corners, seen.weights(u)) - from;
        let [second, third] = recovered(&corners, from, way).map(|part| part.clamp(0.0, 1.0));
        are_none(naive::renormalised(second, third))
    },
    robust_fails: |trial| {
        let (View { corners, from }, u) = at_edge(trial);
        let seen = Spherical::new(&corners, area_vector(&corners), from);
        are_none(seen.weights(u).to_array())
    },
};

fn at_edge(trial: u64) -> (View, Vec2) {
    let mut stream = Stream::of_trial(1334, trial);
    let last = 1.0 - f32::EPSILON / 2.0;
    let mut number = || [0.0, last, stream.uniform()][stream.bits() as usize % 3];
    (View::of(trial), Vec2::new(number(), number()))
}

/// The weights of the second and the third corner of the point in a direction, by the ray's
/// equation in `f32` (Möller and Trumbore, 1997).
fn recovered(&[a, b, c]: &[Vec3; 3], from: Vec3, way: Vec3) -> [f32; 2] {
    let [first, second, start] = [b - a, c - a, from - a];
    let normal = way.cross(second);
    let scale = 1.0 / first.dot(normal);
    [start.dot(normal) * scale, way.dot(start.cross(first)) * scale]
}

fn are_none(weights: [f32; 3]) -> bool {
    let sum: f64 = weights.iter().map(|&weight| f64::from(weight)).sum();
    let is_one = (sum - 1.0).abs() <= 4.0 * f64::from(f32::EPSILON);
    !(is_one && weights.iter().all(|weight| *weight >= 0.0))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use glam::DVec3;

    use super::by_definition;

    /// Half of a cube's face is a twelfth of all directions.
    #[test]
    fn the_oracle_knows_the_cube() {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 1.0));
        assert!((by_definition(corners) / (PI / 3.0) - 1.0).abs() < 1e-7);
    }
}
