//! SH-07: a scene twice as large is the same scene.

use common::sampler::Stream;
use common::tally::Off;
use glam::Vec3;
use ray_casting::quad::Quad;
use ray_casting::ray::Ray;
use ray_casting::shape::{Shape, nearest};
use ray_casting::sphere::Sphere;

use super::draw;
use crate::naive;
use crate::visibility::{End, visible};

/// A floor, a ball and a triangle, a ray that finds a point of them, and a lamp.
struct Scene {
    ray: Ray,
    corner: Vec3,
    edges: [Vec3; 2],
    ball: Sphere,
    triangle: [Vec3; 3],
    lamp: Vec3,
}

fn scene(stream: &mut Stream) -> Scene {
    let mut point = |side| draw::in_cube(stream, side);
    let (corner, edges) = (point(3.0), [point(6.0), point(7.0)]);
    let target = corner + 0.4 * edges[0] + 0.3 * edges[1];
    let eye = point(5.0);
    let lamp = point(6.0);
    // Between the point and the lamp, or beside that.
    let center = target.lerp(lamp, 0.6) + point(1.5);
    let triangle = [(); 3].map(|()| target.lerp(lamp, 0.3) + point(1.5));
    let ball = Sphere { center, radius: stream.between(0.3, 1.2) };
    Scene { ray: Ray { origin: eye, direction: target - eye }, corner, edges, ball, triangle, lamp }
}

impl Scene {
    /// Everything `scale` times as large.
    fn shapes(&self, scale: f32) -> Vec<Box<dyn Shape>> {
        let ball = Sphere { center: scale * self.ball.center, radius: scale * self.ball.radius };
        let triangle = draw::triangle(self.triangle.map(|corner| scale * corner));
        let quad = Quad::new(scale * self.corner, self.edges.map(|edge| scale * edge));
        let quad = quad.map(|quad| Box::new(quad) as Box<dyn Shape>);
        let others: [Box<dyn Shape>; 2] = [Box::new(ball), Box::new(triangle)];
        others.into_iter().chain(quad).collect()
    }

    fn sees_lamp(&self, scale: f32, robust: bool) -> Option<bool> {
        let shapes = self.shapes(scale);
        let lamp = scale * self.lamp;
        let ray = Ray { origin: scale * self.ray.origin, direction: scale * self.ray.direction };
        let hit = nearest(&shapes, &ray, &mut Off)?.hit;
        Some(match robust {
            true => visible(&shapes[..], End::On(&hit), End::Free(lamp), &mut Off),
            false => naive::report_visible(&shapes, hit.point, lamp, &mut Off),
        })
    }
}

fn size_matters(trial: u64, robust: bool) -> bool {
    let mut stream = Stream::of_trial(507, trial);
    let scene = scene(&mut stream);
    let scale = draw::power_of_two(draw::whole(&mut stream, -20, 20));
    scene.sees_lamp(1.0, robust) != scene.sees_lamp(scale, robust)
}

pub(super) fn naive(trial: u64) -> bool {
    size_matters(trial, false)
}

pub(super) fn robust(trial: u64) -> bool {
    size_matters(trial, true)
}
