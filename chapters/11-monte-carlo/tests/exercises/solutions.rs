//! One good answer to each exercise.

use std::f32::consts::{PI, TAU};

use common::math::{cos, sin};
use glam::{Vec2, Vec3};

pub(super) fn disk(u: Vec2) -> Vec2 {
    u.x.sqrt() * Vec2::new(cos(TAU * u.y), sin(TAU * u.y))
}

pub(super) fn irradiance(u: Vec2, radiance: fn(Vec3) -> f32) -> f32 {
    // Directions by the cosine: radiance · cosine / (cosine / π).
    let point = disk(u);
    PI * radiance(point.extend((1.0 - point.length_squared()).max(0.0).sqrt()))
}

pub(super) fn over_triangle(corners: [Vec3; 3], u: Vec2, value: fn(Vec3) -> f32) -> f32 {
    let [a, b, c] = corners;
    let root = u.x.sqrt();
    let point = (1.0 - root) * a + root * (1.0 - u.y) * b + root * u.y * c;
    value(point) * (b - a).cross(c - a).length() / 2.0
}

pub(super) fn one_of_many(weights: &[f32], values: &[f32], u: f32) -> f32 {
    let total: f32 = weights.iter().sum();
    let mut left = u * total;
    let mut estimate = 0.0;
    for (&weight, &value) in weights.iter().zip(values) {
        if weight == 0.0 {
            continue;
        }
        estimate = value * total / weight;
        left -= weight;
        if left < 0.0 {
            break;
        }
    }
    estimate
}

pub(super) fn variance(samples: &[f32]) -> f64 {
    let count = samples.len() as f64;
    let mean = samples.iter().map(|&it| f64::from(it)).sum::<f64>() / count;
    let square = |&it: &f32| (f64::from(it) - mean) * (f64::from(it) - mean);
    samples.iter().map(square).sum::<f64>() / (count - 1.0)
}
