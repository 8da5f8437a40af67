//! One good answer to each exercise.

use common::film::Color;
use common::math;
use glam::Vec3;
use ray_casting::direction::unit;

use crate::cases::{COLORS, Lamp, Lit, Matte, Place, Shiny};

pub(super) fn lambert(case: &Matte) -> Color {
    case.normal.dot(case.toward_light).max(0.0) * case.color * case.diffuse
}

pub(super) fn highlights(case: &Shiny) -> [f32; 2] {
    let Shiny { normal, toward_eye, toward_light, shininess } = *case;
    let mirrored = 2.0 * normal.dot(toward_light) * normal - toward_light;
    let half = (toward_eye + toward_light).normalize();
    [mirrored.dot(toward_eye), normal.dot(half)]
        .map(|cosine| math::pow(cosine.clamp(0.0, 1.0), shininess as f32))
}

pub(super) fn arriving(case: &Lamp) -> Option<(Vec3, Color)> {
    let toward = unit(case.position - case.point)?;
    let distance = (case.position - case.point).dot(toward);
    Some((toward, case.color / (1.0 + distance * distance)))
}

pub(super) fn stripes(case: &Place) -> Color {
    let stripe = (case.uv().x * case.count as f32) as u32;
    COLORS[stripe.min(case.count - 1) as usize % 2]
}

pub(super) fn shade(case: &Lit) -> Color {
    let material = case.material.plain();
    let toward_eye = (case.eye - case.point).normalize();
    let mut sum = material.ambient;
    for arriving in case.lights.iter().filter_map(|light| light.at(case.point)) {
        let cosine = case.normal.dot(arriving.toward);
        if cosine > 0.0 {
            let half = (toward_eye + arriving.toward).normalize_or_zero();
            let strength = math::pow(case.normal.dot(half).clamp(0.0, 1.0), material.shininess);
            sum += arriving.color * (cosine * material.diffuse + strength * material.specular);
        }
    }
    sum
}
