//! SH-09: normals that lean away from the surface must not let light through it.

use std::sync::LazyLock;

use blinn_phong::light::{Arriving, Light};
use blinn_phong::shading::seen_normal;
use common::film::Color;
use common::sampler::Stream;
use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use triangles::bumpy;
use triangles::mesh::Mesh;

use super::draw;
use crate::lighting::{from_lamps, reaches};

/// A closed mesh whose normals at the vertices lean by 45° to 85°.
static LEANING: LazyLock<Box<dyn Shape>> = LazyLock::new(|| {
    let mut mesh: Mesh = bumpy::sphere(60);
    for (number, normal) in (0..).zip(&mut mesh.normals) {
        let mut stream = Stream::of_trial(5090, number);
        let axis = normal.as_dvec3();
        let lean = f64::from(stream.between(1.0, 11.4));
        *normal = (axis + lean * draw::across(&mut stream, axis)).normalize().as_vec3();
    }
    Box::new(mesh)
});

/// A point of the mesh seen from outside and a lamp inside, or the other way round.
fn hit_and_lamp(trial: u64) -> Option<(Hit, Vec3, Vec3)> {
    let mut stream = Stream::of_trial(509, trial);
    let inside = draw::in_cube(&mut stream, 0.35);
    let outside = 3.0 * draw::direction(&mut stream).as_vec3();
    let (eye, lamp, target) = match trial.is_multiple_of(2) {
        true => (outside, inside, draw::in_cube(&mut stream, 0.4)),
        false => (inside, outside, draw::direction(&mut stream).as_vec3()),
    };
    let ray = Ray::new(eye, target - eye)?;
    Some((LEANING.hit(&ray, f32::INFINITY)?, -ray.direction, lamp))
}

/// Lambert's cosine with the leaning normal, on the side that the eye sees.
fn cosine(hit: &Hit, toward_eye: Vec3, arriving: &Arriving) -> Color {
    arriving.color * seen_normal(hit, toward_eye).dot(arriving.toward).max(0.0)
}

/// The leaning normal alone decides, and the ray starts on the lamp's side.
pub(super) fn naive(trial: u64) -> bool {
    let Some((hit, toward_eye, lamp)) = hit_and_lamp(trial) else { return false };
    let light = Light::steady(lamp, Color::ONE);
    let sent = light.at(hit.point).map(|arriving| cosine(&hit, toward_eye, &arriving));
    let scene = std::slice::from_ref(&*LEANING);
    sent.is_some_and(|sent| sent != Color::ZERO) && reaches(scene, &light, &hit, &mut Off)
}

pub(super) fn robust(trial: u64) -> bool {
    let Some((hit, toward_eye, lamp)) = hit_and_lamp(trial) else { return true };
    let light = Light::steady(lamp, Color::ONE);
    let scene = std::slice::from_ref(&*LEANING);
    let returned = |arriving: &Arriving| cosine(&hit, toward_eye, arriving);
    from_lamps::<true, Off>(scene, &[light], &hit, toward_eye, &mut Off, returned) != Color::ZERO
}
