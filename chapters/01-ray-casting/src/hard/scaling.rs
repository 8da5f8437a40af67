//! a scene twice as large is the same scene.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::{CHAPTER, draw};
use crate::naive;
use crate::plane::Plane;
use crate::quad::Quad;
use crate::ray::Ray;
use crate::shape::Shape;
use crate::sphere::Sphere;

/// all lengths times 2^k, which rounds nothing: every t must keep its bits.
pub(super) const POWER_OF_TWO: Case = Case {
    id: "X-08",
    chapter: CHAPTER,
    input: "the whole scene times 2^k, k from -20 to 20: the same bits?",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (scene, scale) = scaled(trial);
        scene.naive_plane(1.0) != scene.naive_plane(scale)
    },
    robust_fails: |trial| {
        let (scene, scale) = scaled(trial);
        scene.distances(1.0) != scene.distances(scale)
    },
};

struct Scene {
    ray: Ray,
    center: Vec3,
    radius: f32,
    corner: Vec3,
    edges: [Vec3; 2],
}

fn scaled(trial: u64) -> (Scene, f32) {
    let mut stream = Stream::of_trial(108, trial);
    let mut point = |side| draw::in_cube(&mut stream, side);
    let scene = Scene {
        ray: Ray { origin: point(5.0), direction: point(1.0) },
        center: point(4.0),
        corner: point(3.0),
        edges: [point(6.0), point(7.0)],
        radius: stream.between(0.5, 4.0),
    };
    let exponent = draw::whole(&mut stream, -20, 20);
    (scene, f32::from_bits(((127 + exponent) as u32) << 23))
}

impl Scene {
    fn ray(&self, scale: f32) -> Ray {
        Ray { origin: self.ray.origin * scale, direction: self.ray.direction * scale }
    }

    /// The distances to the sphere, the plane and the quad, as bits.
    fn distances(&self, scale: f32) -> [Option<u32>; 3] {
        let ray = self.ray(scale);
        let sphere = Sphere { center: self.center * scale, radius: self.radius * scale };
        let corner = self.corner * scale;
        let plane = Plane::new(corner, self.edges[0] * scale);
        let quad = Quad::new(corner, self.edges.map(|edge| edge * scale));
        [
            sphere.hit(&ray, f32::INFINITY),
            plane.and_then(|plane| plane.hit(&ray, f32::INFINITY)),
            quad.and_then(|quad| quad.hit(&ray, f32::INFINITY)),
        ]
        .map(|hit| hit.map(|hit| hit.t.to_bits()))
    }

    fn naive_plane(&self, scale: f32) -> Option<u32> {
        let normal = self.edges[0].normalize();
        naive::plane_distance(self.corner * scale, normal, &self.ray(scale)).map(f32::to_bits)
    }
}
