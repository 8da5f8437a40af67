//! One good answer to each exercise.

use common::film::Color;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use ray_casting::sphere::Sphere;
use shadows::spawn::spawn;

use crate::cases::{Place, Sides};

pub(super) fn sees(spheres: &[Sphere], point: Vec3, lamp: Vec3) -> bool {
    let ray = Ray { origin: point, direction: lamp - point };
    let hit = |sphere: &Sphere| sphere.crossing(&ray).and_then(|crossing| crossing.first(1.0));
    spheres.iter().all(|sphere| hit(sphere).is_none())
}

pub(super) fn light_at(place: &Place) -> Color {
    let mut sum = place.ambient;
    for lamp in place.lamps() {
        let Some(arriving) = lamp.at(place.point) else { continue };
        let cosine = place.normal.dot(arriving.toward);
        let position = place.point + arriving.distance * arriving.toward;
        if cosine > 0.0 && sees(&place.spheres, place.point, position) {
            sum += arriving.color * cosine;
        }
    }
    sum
}

pub(super) fn leave(hit: &Hit, direction: Vec3) -> Vec3 {
    let reach = hit.geometric.abs().dot(hit.error);
    let side = if hit.geometric.dot(direction) < 0.0 { -1.0 } else { 1.0 };
    let offset = side * reach * hit.geometric;
    let mut origin = hit.point + offset;
    for axis in 0..3 {
        if offset[axis] > 0.0 {
            origin[axis] = origin[axis].next_up();
        } else if offset[axis] < 0.0 {
            origin[axis] = origin[axis].next_down();
        }
    }
    origin
}

pub(super) fn sees_lamp(shapes: &[Box<dyn Shape>], hit: &Hit, lamp: Vec3) -> bool {
    let origin = spawn(hit, lamp - hit.point);
    let ray = Ray { origin, direction: lamp - origin };
    !shapes.iter().any(|shape| shape.is_hit(&ray, 1.0))
}

pub(super) fn arriving_cosine(sides: &Sides) -> f32 {
    let Sides { geometric, shading, eye, lamp } = *sides;
    let outward = if geometric.dot(eye) < 0.0 { -geometric } else { geometric };
    let normal = if shading.dot(outward) < 0.0 { -shading } else { shading };
    if outward.dot(lamp) > 0.0 { normal.dot(lamp).max(0.0) } else { 0.0 }
}
