//! One good answer to each exercise.

use std::f32::consts::PI;

use common::film::Color;
use glam::{Vec2, Vec3};

use crate::cases::Arrival;

pub(super) fn density(distance: f32, cosine: f32, area: f32) -> f32 {
    distance * distance / (area * cosine)
}

pub(super) fn direct(normal: Vec3, albedo: f32, corners: [Vec3; 3], radiance: f32, u: Vec2) -> f32 {
    let [a, b, c] = corners;
    let root = u.x.sqrt();
    let point = (1.0 - root) * a + root * (1.0 - u.y) * b + root * u.y * c;
    let (distance, across) = (point.length(), (b - a).cross(c - a));
    let direction = point / distance;
    let lamp_cosine = -direction.dot(across) / across.length();
    let cosine = direction.dot(normal);
    if lamp_cosine <= 0.0 || cosine <= 0.0 {
        return 0.0;
    }
    let area = 0.5 * across.length();
    radiance * albedo / PI * cosine / density(distance, lamp_cosine, area)
}

pub(super) fn ball_density(distance: f32, radius: f32) -> f32 {
    let sine = radius / distance;
    let cosine = ((1.0 - sine) * (1.0 + sine)).sqrt();
    (1.0 + cosine) / (2.0 * PI * sine * sine)
}

pub(super) fn one_lamp(powers: &[f32], lights: &[f32], chance: f32) -> f32 {
    let total: f32 = powers.iter().sum();
    let mut rest = chance * total;
    for (power, light) in powers.iter().zip(lights) {
        if rest < *power {
            return light * total / power;
        }
        rest -= power;
    }
    0.0
}

pub(super) fn share(arrival: &Arrival) -> f32 {
    let Arrival { from_eye, from_mirror, is_chosen } = *arrival;
    if from_eye || from_mirror || !is_chosen { 1.0 } else { 0.0 }
}

pub(super) fn light(
    radiance: Color,
    brdf: Color,
    cosine: f32,
    lamp_cosine: f32,
    distance: f32,
    density: f32,
) -> Color {
    radiance * brdf * cosine * lamp_cosine.max(0.0) / (distance * distance) / density
}
