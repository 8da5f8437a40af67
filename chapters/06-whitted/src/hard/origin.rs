//! WH-15 and X-08: where the ray of a mirror starts.

use common::hard::{Case, UNLIMITED};
use common::math;
use common::sampler::Stream;
use glam::Vec3;
use ray_casting::quad::Quad;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use ray_casting::sphere::Sphere;

use super::{CHAPTER, across, direction};
use crate::mirror::{leaving, mirrored};
use crate::naive::framework_origin;

/// WH-15: a sphere from outside or a quad: a ray that left it can't meet it again.
pub(super) const OWN_MIRROR: Case = Case {
    id: "WH-15",
    chapter: CHAPTER,
    input: "a ray that leaves a ball or a flat mirror, from 0.01 to 10,000 across",
    most: UNLIMITED,
    naive_fails: |trial| meets_itself(trial, published),
    robust_fails: |trial| meets_itself(trial, mirrored),
};

/// everything 2^k times as large, so that the ray has the same direction and its origin is
/// 2^k times as far away, to the bit.
pub(super) const POWER_OF_TWO: Case = Case {
    id: "X-08",
    chapter: CHAPTER,
    input: "a mirror and its ray, 2^k times as large",
    most: UNLIMITED,
    naive_fails: |trial| depends_on_scale(trial, published),
    robust_fails: |trial| depends_on_scale(trial, mirrored),
};

/// The ray as the report's framework lets it start, which has an epsilon of 0.00001.
fn published(ray: &Ray, hit: &Hit) -> Option<Ray> {
    let direction = leaving(ray.direction, hit)?;
    Some(Ray { origin: framework_origin(hit.point, hit.normal, direction, 1e-5), direction })
}

/// Whether the mirrored ray hits the mirror that it left.
fn meets_itself(trial: u64, formula: fn(&Ray, &Hit) -> Option<Ray>) -> bool {
    let (shape, ray) = aimed(trial, 1.0);
    // The few that miss a ball's rim prove nothing.
    let Some(hit) = shape.hit(&ray, f32::INFINITY) else { return false };
    let next = formula(&ray, &hit);
    next.is_none_or(|next| shape.hit(&next, f32::INFINITY).is_some())
}

fn depends_on_scale(trial: u64, formula: fn(&Ray, &Hit) -> Option<Ray>) -> bool {
    let exponent = (trial % 41) as i32 - 20;
    let scale = f32::from_bits(((127 + exponent) as u32) << 23);
    let next = |scale| {
        let (shape, ray) = aimed(trial, scale);
        let hit = shape.hit(&ray, f32::INFINITY)?;
        formula(&ray, &hit)
    };
    let scaled = next(1.0).map(|ray| Ray { origin: ray.origin * scale, ..ray });
    next(scale) != scaled
}

/// A mirror somewhere, and a ray towards it from outside; all lengths times `scale`.
fn aimed(trial: u64, scale: f32) -> (Box<dyn Shape>, Ray) {
    let mut stream = Stream::of_trial(615, trial);
    let size = math::pow(10.0, stream.between(-2.0, 4.0));
    let center = size * stream.between(0.0, 30.0) * direction(&mut stream);
    let toward = direction(&mut stream);
    let eye = center + size * stream.between(1.5, 40.0) * toward;
    let aside = across(&mut stream, toward);
    let aim = center + 0.95 * size * stream.uniform() * aside;
    let ray = Ray::new(eye * scale, (aim - eye) * scale);
    let ray = ray.unwrap_or(Ray { origin: eye * scale, direction: -toward });
    let (center, size) = (center * scale, size * scale);
    let ball = Sphere { center, radius: size };
    let quad =
        if trial.is_multiple_of(2) { None } else { slanted(&mut stream, center, toward, size) };
    (quad.map_or(Box::new(ball) as Box<dyn Shape>, |quad| Box::new(quad)), ray)
}

/// A quad around `center` that faces `toward`, or nearly turns its edge to it.
fn slanted(stream: &mut Stream, center: Vec3, toward: Vec3, size: f32) -> Option<Quad> {
    let one = across(stream, toward);
    let other = one.cross(toward) + stream.between(-20.0, 20.0) * toward;
    let edges = [3.0 * size * one, 3.0 * size * other];
    Quad::new(center - 0.5 * edges[0] - 0.5 * edges[1], edges)
}
