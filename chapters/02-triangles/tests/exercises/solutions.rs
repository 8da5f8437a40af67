//! One right answer to each exercise.

use std::collections::HashSet;

use glam::Vec3;

use crate::{Blend, Edge, Question};

pub(crate) fn edge_function(Edge { p, q }: &Edge) -> f64 {
    f64::from(p.x) * f64::from(q.y) - f64::from(p.y) * f64::from(q.x)
}

pub(crate) fn intersect(case: &Question) -> Option<f32> {
    let [a, b, c] = case.corners;
    let (ab, ac) = (b - a, c - a);
    let p = case.direction.cross(ac);
    let determinant = ab.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let s = case.origin - a;
    let q = s.cross(ab);
    let v = s.dot(p) / determinant;
    let w = case.direction.dot(q) / determinant;
    let t = ac.dot(q) / determinant;
    (v >= 0.0 && w >= 0.0 && v + w <= 1.0 && t > 0.0).then_some(t)
}

pub(crate) fn smooth_normal(case: &Blend) -> Vec3 {
    let [a, b, c] = case.normals;
    let mean = case.weights.x * a + case.weights.y * b + case.weights.z * c;
    if mean.length() < 1e-4 { case.geometric } else { mean.normalize() }
}

pub(crate) fn has_area((corners, _): &([Vec3; 3], bool)) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    (b - a).cross(c - a) != glam::DVec3::ZERO
}

pub(crate) fn is_closed((triangles, _): &(Vec<[u32; 3]>, bool)) -> bool {
    let mut edges = HashSet::new();
    for &[a, b, c] in triangles {
        for edge in [[a, b], [b, c], [c, a]] {
            if !edges.insert(edge) {
                return false;
            }
        }
    }
    edges.iter().all(|&[from, to]| edges.contains(&[to, from]))
}
