//! SH-10: light that can go one way can go the other.

use common::sampler::Stream;
use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use ray_casting::sphere::Sphere;

use super::draw;
use crate::naive;
use crate::visibility::{End, between, visible};

/// Two points, on balls or in the open, and a third ball whose rim is a few roundings from the line
/// between them.
struct Scene {
    shapes: Vec<Box<dyn Shape>>,
    ends: [Result<Hit, Vec3>; 2],
}

fn scene(trial: u64) -> Scene {
    let mut stream = Stream::of_trial(510, trial);
    let centers =
        [draw::in_cube(&mut stream, 2.0), Vec3::Z * 9.0 + draw::in_cube(&mut stream, 2.0)];
    let balls = centers.map(|center| Sphere { center, radius: stream.between(0.5, 1.5) });
    let way = centers[1] - centers[0];
    let ends = [(balls[0], way), (balls[1], -way)].map(|(ball, way)| {
        let ray = Ray { origin: ball.center, direction: way + draw::in_cube(&mut stream, 3.0) };
        let free = stream.bits().is_multiple_of(4);
        let hit = ball.hit(&ray, f32::INFINITY).filter(|_| !free);
        hit.ok_or(ball.center + 2.0 * ball.radius * way / way.length())
    });
    let [one, other] = [point(&ends[0]), point(&ends[1])];
    let line = (other - one).as_dvec3();
    let radius = stream.between(0.1, 1.5);
    let near = f64::from(radius) * (1.0 + f64::from(stream.between(-2e-6, 2e-6)));
    let along = f64::from(stream.between(0.3, 0.7)) * line;
    let beside = draw::across(&mut stream, line.normalize()) * near;
    let rim = Sphere { center: (one.as_dvec3() + along + beside).as_vec3(), radius };
    let shapes = [balls[0], balls[1], rim].map(|ball| Box::new(ball) as Box<dyn Shape>);
    Scene { shapes: shapes.into(), ends }
}

fn point(end: &Result<Hit, Vec3>) -> Vec3 {
    end.as_ref().map_or_else(|point| *point, |hit| hit.point)
}

pub(super) fn naive(trial: u64) -> bool {
    let Scene { shapes, ends } = scene(trial);
    let [one, other] = [point(&ends[0]), point(&ends[1])];
    let sees = |from, to| naive::report_visible(&shapes, from, to, &mut Off);
    sees(one, other) != sees(other, one)
}

/// The answer, and every bit of the ray that is asked about.
pub(super) fn robust(trial: u64) -> bool {
    let Scene { shapes, ends } = scene(trial);
    let [one, other] = [&ends[0], &ends[1]].map(|end| match end {
        Ok(hit) => End::On(hit),
        Err(point) => End::Free(*point),
    });
    let bits = |ray: Ray| [ray.origin, ray.direction].map(|it| it.to_array().map(f32::to_bits));
    let sees = |one, other| visible(&shapes[..], one, other, &mut Off);
    sees(one, other) != sees(other, one) || bits(between(one, other)) != bits(between(other, one))
}
