//! One good answer to each exercise.

use common::film::Color;
use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::{Shape, nearest};
use whitted::exercises::{Ball, Met, Node};
use whitted::mirror::mirrored;

pub(super) fn mirror_direction(incoming: Vec3, normal: Vec3) -> Vec3 {
    incoming - 2.0 * incoming.dot(normal) * normal
}

pub(super) fn along(surfaces: &[Met], depth: u32, cutoff: f32) -> f32 {
    let (mut sum, mut throughput) = (0.0, 1.0);
    for (followed, met) in (0..).zip(surfaces) {
        if followed > 0 && (followed > depth || throughput <= cutoff) {
            break;
        }
        sum += throughput * met.light;
        throughput *= met.mirror;
    }
    sum
}

/// The ball that the ray meets first, and where.
pub(super) fn first<'a>(
    balls: &'a [Ball],
    ray: &Ray,
) -> Option<(&'a Ball, ray_casting::shape::Hit)> {
    let shapes: Vec<Box<dyn Shape>> =
        balls.iter().map(|ball| Box::new(ball.sphere) as Box<dyn Shape>).collect();
    let found = nearest(&shapes, ray, &mut Off)?;
    Some((&balls[found.index], found.hit))
}

pub(super) fn among(balls: &[Ball], background: Color, ray: &Ray, depth: u32) -> Color {
    let Some((ball, hit)) = first(balls, ray) else { return background };
    if depth == 0 {
        return ball.light;
    }
    let rest = mirrored(ray, &hit).map(|ray| among(balls, background, &ray, depth - 1));
    ball.light + ball.mirror * rest.unwrap_or(Color::ZERO)
}

pub(super) fn total(meet: &dyn Fn(usize) -> Node) -> f64 {
    let mut sum = 0.0;
    let mut waiting = vec![(0, 1.0)];
    while let Some((number, throughput)) = waiting.pop() {
        let Node { light, branches } = meet(number);
        sum += throughput * light;
        waiting.extend(branches.iter().map(|&(branch, weight)| (branch, throughput * weight)));
    }
    sum
}

pub(super) fn depth_needed(mirror: f64, missing: f64) -> u32 {
    // What is missing at depth n is the part ρⁿ⁺¹ of all.
    let (mut left, mut depth) = (mirror, 0);
    while left > missing {
        left *= mirror;
        depth += 1;
    }
    depth
}

pub(super) fn mirror_origin(point: Vec3, normal: Vec3, direction: Vec3, epsilon: f32) -> Vec3 {
    if direction.dot(normal) < 0.0 { point - normal * epsilon } else { point + normal * epsilon }
}
