//! What readers get wrong.

use std::collections::{HashMap, HashSet};

use glam::{DVec3, Vec3};
use triangles::closed::edges_without_partner;

use crate::{Blend, Edge, Question};

pub(crate) fn edge_in_f32(Edge { p, q }: &Edge) -> f64 {
    f64::from(p.x * q.y - p.y * q.x)
}

pub(crate) fn edge_turned(Edge { p, q }: &Edge) -> f64 {
    f64::from(p.y) * f64::from(q.x) - f64::from(p.x) * f64::from(q.y)
}

pub(crate) fn edge_sum(Edge { p, q }: &Edge) -> f64 {
    f64::from(p.x) * f64::from(q.y) + f64::from(p.y) * f64::from(q.x)
}

pub(crate) fn edge_dot(Edge { p, q }: &Edge) -> f64 {
    f64::from(p.x) * f64::from(q.x) + f64::from(p.y) * f64::from(q.y)
}

/// What Cramer's rule gives before anything is decided.
struct Cramer {
    determinant: f32,
    v: f32,
    w: f32,
    t: f32,
}

impl Cramer {
    fn of(case: &Question) -> Self {
        let [a, b, c] = case.corners;
        let (ab, ac) = (b - a, c - a);
        let p = case.direction.cross(ac);
        let determinant = ab.dot(p);
        let s = case.origin - a;
        let q = s.cross(ab);
        let (v, w) = (s.dot(p) / determinant, case.direction.dot(q) / determinant);
        Self { determinant, v, w, t: ac.dot(q) / determinant }
    }

    fn inside(&self) -> bool {
        self.v >= 0.0 && self.w >= 0.0 && self.v + self.w <= 1.0
    }
}

pub(crate) fn intersect_epsilon(case: &Question) -> Option<f32> {
    let cramer = Cramer::of(case);
    (cramer.determinant.abs() > 1e-6 && cramer.inside() && cramer.t > 0.0).then_some(cramer.t)
}

pub(crate) fn intersect_culled(case: &Question) -> Option<f32> {
    let cramer = Cramer::of(case);
    (cramer.determinant > 0.0 && cramer.inside() && cramer.t > 0.0).then_some(cramer.t)
}

pub(crate) fn intersect_parallelogram(case: &Question) -> Option<f32> {
    let Cramer { v, w, t, .. } = Cramer::of(case);
    let between = |weight| (0.0..=1.0).contains(&weight);
    (between(v) && between(w) && t > 0.0).then_some(t)
}

pub(crate) fn intersect_behind(case: &Question) -> Option<f32> {
    let cramer = Cramer::of(case);
    cramer.inside().then_some(cramer.t)
}

pub(crate) fn intersect_undivided(case: &Question) -> Option<f32> {
    let cramer = Cramer::of(case);
    (cramer.inside() && cramer.t > 0.0).then_some(cramer.t * cramer.determinant)
}

fn mean([a, b, c]: [Vec3; 3], weights: Vec3) -> Vec3 {
    weights.x * a + weights.y * b + weights.z * c
}

pub(crate) fn blend_short(case: &Blend) -> Vec3 {
    let mean = mean(case.normals, case.weights);
    if mean.length() < 1e-4 { case.geometric } else { mean }
}

pub(crate) fn blend_rotated(case: &Blend) -> Vec3 {
    let [a, b, c] = case.normals;
    let mean = mean([b, c, a], case.weights);
    if mean.length() < 1e-4 { case.geometric } else { mean.normalize() }
}

pub(crate) fn blend_unguarded(case: &Blend) -> Vec3 {
    mean(case.normals, case.weights).normalize()
}

pub(crate) fn blend_flat(case: &Blend) -> Vec3 {
    case.geometric
}

fn cross([a, b, c]: &[Vec3; 3]) -> Vec3 {
    (*b - *a).cross(*c - *a)
}

pub(crate) fn area_squared((corners, _): &([Vec3; 3], bool)) -> bool {
    cross(corners).length_squared() != 0.0
}

pub(crate) fn area_components((corners, _): &([Vec3; 3], bool)) -> bool {
    cross(corners) != Vec3::ZERO
}

pub(crate) fn area_squared_above((corners, _): &([Vec3; 3], bool)) -> bool {
    cross(corners).length_squared() > 0.0
}

pub(crate) fn area_components_above((corners, _): &([Vec3; 3], bool)) -> bool {
    cross(corners).abs().cmpgt(Vec3::ZERO).any()
}

pub(crate) fn area_positive((corners, _): &([Vec3; 3], bool)) -> bool {
    cross(corners).cmpgt(Vec3::ZERO).any()
}

pub(crate) fn area_positive_in_f64((corners, _): &([Vec3; 3], bool)) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    (b - a).cross(c - a).cmpgt(DVec3::ZERO).any()
}

pub(crate) fn area_epsilon((corners, _): &([Vec3; 3], bool)) -> bool {
    cross(corners).length() > 1e-6
}

pub(crate) fn area_corners((corners, _): &([Vec3; 3], bool)) -> bool {
    let [a, b, c] = corners;
    a != b && b != c && c != a
}

fn directed_edges(triangles: &[[u32; 3]]) -> impl Iterator<Item = [u32; 2]> {
    triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
}

fn undirected([from, to]: [u32; 2]) -> [u32; 2] {
    [from.min(to), from.max(to)]
}

pub(crate) fn closed_undirected((triangles, _): &(Vec<[u32; 3]>, bool)) -> bool {
    let mut counts: HashMap<[u32; 2], u32> = HashMap::new();
    for edge in directed_edges(triangles) {
        *counts.entry(undirected(edge)).or_default() += 1;
    }
    counts.values().all(|&count| count == 2)
}

pub(crate) fn closed_loosely((triangles, _): &(Vec<[u32; 3]>, bool)) -> bool {
    let edges: HashSet<[u32; 2]> = directed_edges(triangles).collect();
    edges.iter().all(|&[from, to]| edges.contains(&[to, from]))
}

pub(crate) fn closed_by_balance((triangles, _): &(Vec<[u32; 3]>, bool)) -> bool {
    edges_without_partner(triangles) == 0
}

pub(crate) fn closed_by_count((triangles, _): &(Vec<[u32; 3]>, bool)) -> bool {
    let edges: HashSet<[u32; 2]> = directed_edges(triangles).map(undirected).collect();
    2 * edges.len() == 3 * triangles.len()
}
