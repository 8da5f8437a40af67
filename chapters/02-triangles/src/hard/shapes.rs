//! Random triangles and rays, and what several cases ask of them.

use common::sampler::Stream;
use glam::{DVec3, Vec3};
use ray_casting::ray::Ray;

use crate::intersect::{TriangleHit, TriangleTest};

/// Three corners.
pub(crate) type Corners = [Vec3; 3];

/// The answer of one test to one ray and one triangle.
pub(crate) fn ask<Test: TriangleTest>(
    ray: &Ray,
    corners: &Corners,
    t_max: f32,
) -> Option<TriangleHit> {
    Test::prepare(ray)?.hit(corners, t_max)
}

/// A point of a lopsided box: 2 by 4 by 6 around the origin.
pub(crate) fn point(stream: &mut Stream) -> Vec3 {
    let x = stream.between(-1.0, 1.0);
    let y = stream.between(-2.0, 2.0);
    Vec3::new(x, y, stream.between(-3.0, 3.0))
}

/// A triangle of three such points.
pub(crate) fn triangle(stream: &mut Stream) -> Corners {
    let a = point(stream);
    let b = point(stream);
    [a, b, point(stream)]
}

/// Weights that make a point well inside, each at least 0.2.
pub(crate) fn inner_weights(stream: &mut Stream) -> Vec3 {
    let spread = Vec3::new(stream.uniform(), stream.uniform(), stream.uniform());
    Vec3::splat(0.2) + 0.4 * spread / (spread.element_sum() + 1e-9)
}

/// The point with these weights.
pub(crate) fn mix([a, b, c]: &Corners, weights: Vec3) -> Vec3 {
    weights.x * *a + weights.y * *b + weights.z * *c
}

/// The ray from `origin` at `target`, of length 1 where that is possible.
pub(crate) fn towards(origin: Vec3, target: Vec3) -> Option<Ray> {
    Ray::new(origin, target - origin)
}

/// How far a point is from a triangle, in f64 (Ericson, "Real-Time Collision Detection", 2005,
/// section 5.1.5, by the nearest of three segments where the foot lies outside).
pub(crate) fn distance(point: DVec3, corners: &Corners) -> f64 {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let normal = (b - a).cross(c - a);
    let side = |p: DVec3, q: DVec3| (q - p).cross(point - p).dot(normal) >= 0.0;
    if normal != DVec3::ZERO && side(a, b) && side(b, c) && side(c, a) {
        return (point - a).dot(normal).abs() / normal.length();
    }
    let to_segment = |p: DVec3, q: DVec3| {
        let along = ((point - p).dot(q - p) / (q - p).length_squared()).clamp(0.0, 1.0);
        (point - (p + along * (q - p))).length()
    };
    to_segment(a, b).min(to_segment(b, c)).min(to_segment(c, a))
}
