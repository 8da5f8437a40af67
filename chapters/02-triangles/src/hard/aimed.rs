//! TR-02, TR-04 and TR-10: rays from inside a closed mesh, aimed at its edges and vertices.
//!
//! Such a ray has to hit something. One that doesn't has slipped through a crack.

use std::sync::LazyLock;

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::shapes::towards;
use crate::brute::nearest;
use crate::bumpy;
use crate::bunny::bunny;
use crate::convert::Normals;
use crate::intersect::TriangleTest;
use crate::naive::MollerTrumbore;
use crate::watertight::ShearedRay;

/// A closed mesh, a point well inside it, and which triangles meet at each vertex.
pub(crate) struct Closed {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) corners: Vec<[Vec3; 3]>,
    inside: Vec3,
    fans: Vec<Vec<u32>>,
}

/// The bumpy spheres, and the bunny.
pub(crate) static NEAR: LazyLock<Vec<Closed>> = LazyLock::new(|| {
    let spheres = [96, 960].map(|size| Closed::sphere(size, Vec3::ZERO));
    let bunny = bunny(Normals::Flat)
        .map(|mesh| Closed::new(mesh.positions, mesh.triangles, Vec3::new(0.3, 3.4, 0.4)));
    spheres.into_iter().chain(bunny).collect()
});

/// Spheres where Embree's own test has them, and farther out.
static FAR: LazyLock<Vec<Closed>> = LazyLock::new(|| {
    let away = Vec3::new(148_376.0, 1_234.0, -223_423.0);
    vec![Closed::sphere(960, 0.004 * away), Closed::sphere(960, 0.06 * away)]
});

impl Closed {
    fn sphere(size: u32, offset: Vec3) -> Self {
        let mesh = bumpy::sphere(size);
        let positions = mesh.positions.iter().map(|&place| 2.0 * place + offset).collect();
        Self::new(positions, mesh.triangles, offset)
    }

    fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>, inside: Vec3) -> Self {
        let corners: Vec<[Vec3; 3]> =
            triangles.iter().map(|it| it.map(|vertex| positions[vertex as usize])).collect();
        let mut fans = vec![Vec::new(); positions.len()];
        for (number, triangle) in (0..).zip(&triangles) {
            for &vertex in triangle {
                fans[vertex as usize].push(number);
            }
        }
        Self { positions, triangles, corners, inside, fans }
    }

    /// Whether the ray at an edge of the mesh hits nothing. Most hit at once what they are aimed
    /// at; only for the others every triangle is asked.
    pub(crate) fn is_missed<Test: TriangleTest>(&self, aim: &Aim) -> bool {
        let Some(test) = Test::prepare(&aim.ray) else { return true };
        let hits =
            |number: &u32| test.hit(&self.corners[*number as usize], f32::INFINITY).is_some();
        let around = aim.vertices.iter().flat_map(|&vertex| &self.fans[vertex as usize]);
        !around.into_iter().any(hits)
            && nearest::<Test>(&self.corners, &aim.ray, f32::INFINITY).is_none()
    }

    /// A ray from near the middle at a point of a random edge.
    pub(crate) fn at_edge(&self, stream: &mut Stream) -> Option<Aim> {
        let edge = self.edge(stream);
        let [p, q] = edge.vertices.map(|vertex| self.positions[vertex as usize]);
        let along = stream.uniform();
        self.aim(p + along * (q - p), edge, stream)
    }

    /// A ray from near the middle at a random vertex.
    fn at_vertex(&self, stream: &mut Stream) -> Option<Aim> {
        let edge = self.edge(stream);
        self.aim(self.positions[edge.vertices[0] as usize], edge, stream)
    }

    fn edge(&self, stream: &mut Stream) -> Edge {
        let triangle = stream.bits() as usize % self.triangles.len();
        let first = stream.bits() as usize % 3;
        let vertices = self.triangles[triangle];
        Edge { triangle, vertices: [vertices[first], vertices[(first + 1) % 3]] }
    }

    fn aim(&self, target: Vec3, edge: Edge, stream: &mut Stream) -> Option<Aim> {
        let around = Vec3::new(stream.uniform(), stream.uniform(), stream.uniform()) - 0.5;
        let Edge { vertices, triangle } = edge;
        let ray = towards(self.inside + 0.5 * around, target)?;
        Some(Aim { ray, vertices, triangle })
    }
}

/// An edge of a triangle.
struct Edge {
    triangle: usize,
    vertices: [u32; 2],
}

/// A ray aimed at the edge between two vertices.
pub(crate) struct Aim {
    /// The ray.
    pub(crate) ray: Ray,
    vertices: [u32; 2],
    /// One of the triangles at the edge.
    pub(crate) triangle: usize,
}

/// A way to aim at a mesh.
type AimAt = fn(&Closed, &mut Stream) -> Option<Aim>;

fn slips_through<Test: TriangleTest>(meshes: &[Closed], at: AimAt, trial: u64) -> bool {
    let mut stream = Stream::of_trial(202, trial);
    let mesh = &meshes[(trial % meshes.len() as u64) as usize];
    at(mesh, &mut stream).is_some_and(|aim| mesh.is_missed::<Test>(&aim))
}

pub(super) fn edge_naive(trial: u64) -> bool {
    slips_through::<MollerTrumbore>(&NEAR, Closed::at_edge, trial)
}

pub(super) fn edge_robust(trial: u64) -> bool {
    slips_through::<ShearedRay>(&NEAR, Closed::at_edge, trial)
}

pub(super) fn vertex_naive(trial: u64) -> bool {
    slips_through::<MollerTrumbore>(&NEAR, Closed::at_vertex, trial)
}

pub(super) fn vertex_robust(trial: u64) -> bool {
    slips_through::<ShearedRay>(&NEAR, Closed::at_vertex, trial)
}

pub(super) fn far_naive(trial: u64) -> bool {
    slips_through::<MollerTrumbore>(&FAR, Closed::at_vertex, trial)
}

pub(super) fn far_robust(trial: u64) -> bool {
    slips_through::<ShearedRay>(&FAR, Closed::at_vertex, trial)
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;

    use super::{FAR, NEAR};
    use crate::brute::nearest;
    use crate::closed::edges_without_partner;
    use crate::reference::DoubleRay;
    use crate::watertight::ShearedRay;

    /// Whether a ray has to hit says the f64 reference, for rays that aren't aimed at edges.
    #[test]
    fn the_meshes_are_closed_around_their_insides() {
        for mesh in NEAR.iter().chain(FAR.iter()) {
            assert_eq!(edges_without_partner(&mesh.triangles), 0);
            for trial in 0..300 {
                let mut stream = Stream::of_trial(7, trial);
                let aim = mesh.at_edge(&mut stream).expect("an edge is not at the middle");
                let mut ray = aim.ray;
                ray.direction =
                    (ray.direction + 0.05 * super::Vec3::splat(stream.uniform())).normalize();
                assert!(nearest::<DoubleRay>(&mesh.corners, &ray, f32::INFINITY).is_some());
            }
        }
    }

    /// TR-04: around a vertex all triangles that are hit agree on the distance.
    #[test]
    fn the_fan_around_a_vertex_agrees() {
        let mut most_ulps = 0;
        for trial in 0..20_000 {
            let mesh = &NEAR[1];
            let mut stream = Stream::of_trial(8, trial);
            let aim = mesh.at_vertex(&mut stream).expect("a vertex is not at the middle");
            let test = <ShearedRay as crate::intersect::TriangleTest>::prepare(&aim.ray);
            let test = test.expect("finite");
            let hits = mesh.corners.iter().filter_map(|corners| {
                crate::intersect::TriangleTest::hit(&test, corners, f32::INFINITY)
            });
            let bits: Vec<u32> = hits.map(|hit| hit.t.to_bits()).collect();
            let low = bits.iter().min().expect("something is hit");
            let high = bits.iter().max().expect("something is hit");
            most_ulps = most_ulps.max(high - low);
        }
        assert!(most_ulps <= 2, "{most_ulps}");
    }
}
