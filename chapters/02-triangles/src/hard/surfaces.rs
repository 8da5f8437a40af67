//! TR-11 and TR-14: normals of slivers, and of vertices among faces without area.

use common::sampler::Stream;
use glam::Vec3;

use super::shapes::point;
use crate::naive;
use crate::smooth::vertex_normals;
use crate::surface::geometric_normal;

/// TR-11: a sliver with corners of whole numbers up to 2^20, and its exact normal: the cross
/// product of whole numbers, rounded once.
fn sliver_normal_wrong(trial: u64, normal: fn(&[Vec3; 3]) -> Option<Vec3>) -> bool {
    let mut stream = Stream::of_trial(211, trial);
    let a = (100_000.0 * point(&mut stream)).round();
    let ab = (100_000.0 * point(&mut stream)).round();
    let c = (a + stream.uniform() * ab + 3.0 * point(&mut stream)).round();
    let corners = [a, a + ab, c];
    let exact = exact_normal(&corners);
    let Some(exact) = exact else { return false };
    // Sixteen rounding units, whatever the condition of the triangle.
    !normal(&corners).is_some_and(|it| (it - exact).abs().max_element() <= 8.0 * f32::EPSILON)
}

fn exact_normal(corners: &[Vec3; 3]) -> Option<Vec3> {
    let [a, b, c] = corners.map(|corner| corner.to_array().map(|coordinate| coordinate as i128));
    let minor = |i: usize, j: usize| (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    let cross = glam::DVec3::new(minor(1, 2) as f64, minor(2, 0) as f64, minor(0, 1) as f64);
    cross.try_normalize().map(|normal| normal.as_vec3())
}

pub(super) fn sliver_naive(trial: u64) -> bool {
    sliver_normal_wrong(trial, |corners| Some(naive::geometric_normal(corners)))
}

pub(super) fn sliver_robust(trial: u64) -> bool {
    sliver_normal_wrong(trial, geometric_normal)
}

/// A way to compute vertex normals.
type VertexNormals = fn(&[Vec3], &[[u32; 3]]) -> Vec<Vec3>;

/// TR-14: a fan of triangles, to which are added faces without area, a face there and back again,
/// and a vertex of its own. All normals must have length 1, and those of the fan must not change.
fn normals_spoiled(trial: u64, normals: VertexNormals) -> bool {
    let mut stream = Stream::of_trial(214, trial);
    let mut positions: Vec<Vec3> = (0..6).map(|_| point(&mut stream)).collect();
    let middle = 0.5 * positions[0] + 0.5 * positions[1];
    // Seven lies on the edge from 0 to 1 as far as rounding allows; exactly on it it is 0 again.
    positions.extend([positions[0], middle, point(&mut stream)]);
    let fan = [[0, 1, 2], [0, 2, 3], [0, 3, 4]];
    let clean = normals(&positions, &fan);
    let degenerate = [[0, 0, 1], [1, 2, 1], [0, 6, 3], [5, 5, 5], [5, 4, 5], [8, 5, 8], [8, 8, 8]];
    let there_and_back = [[6, 7, 8], [6, 8, 7]];
    let all: Vec<[u32; 3]> = degenerate.into_iter().chain(fan).chain(there_and_back).collect();
    let spoiled = normals(&positions, &all);
    let unit = |normal: &Vec3| (normal.length() - 1.0).abs() < 1e-6;
    !spoiled.iter().all(unit) || clean[..5].iter().ne(&spoiled[..5])
}

pub(super) fn normals_naive(trial: u64) -> bool {
    normals_spoiled(trial, naive::vertex_normals)
}

pub(super) fn normals_robust(trial: u64) -> bool {
    normals_spoiled(trial, vertex_normals)
}
