//! SH-04: what is right before the lamp, and a lamp on a wall.

use common::sampler::Stream;
use common::tally::Off;
use glam::{DVec3, Vec3};
use ray_casting::quad::Quad;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use ray_casting::sphere::Sphere;

use super::draw;
use crate::naive;
use crate::visibility::{End, visible};

/// A floor point, a lamp, and what else there is.
struct Scene {
    shapes: Vec<Box<dyn Shape>>,
    floor: Hit,
    lamp: Vec3,
    /// The wall that the lamp is on; without one there is a lid before the lamp.
    wall: Option<Hit>,
}

fn scene(trial: u64) -> Scene {
    let mut stream = Stream::of_trial(504, trial);
    loop {
        let made = draw_scene(&mut stream, trial.is_multiple_of(2));
        if let Some(scene) = made {
            return scene;
        }
    }
}

/// The lamp is 10⁻⁴ to 10⁴ away; both surfaces are seen at a cosine of 10⁻³ or more.
fn draw_scene(stream: &mut Stream, on_wall: bool) -> Option<Scene> {
    let distance = draw::decade(stream, -4.0, 4.0);
    let place = distance * draw::in_cube(stream, 0.7);
    let way = draw::direction(stream);
    let floor = patch(stream, place, way, distance)?;
    let lamp = (place.as_dvec3() + f64::from(distance) * way).as_vec3();
    let floor_hit = struck(floor.as_ref(), place, way, distance)?;
    if on_wall {
        let size = distance * draw::decade(stream, -2.0, 0.0);
        let wall = patch(stream, lamp, -way, size)?;
        let hit = struck(wall.as_ref(), lamp, -way, distance)?;
        if !(faces(&hit, floor_hit.point) && faces(&floor_hit, hit.point)) {
            return None;
        }
        let shapes = vec![floor, wall];
        return Some(Scene { shapes, floor: floor_hit, lamp: hit.point, wall: Some(hit) });
    }
    let shapes = vec![floor, Box::new(lid(stream, lamp, way, distance)) as Box<dyn Shape>];
    Some(Scene { shapes, floor: floor_hit, lamp, wall: None })
}

/// A triangle across the way, 64 to 4096 floats before the lamp.
fn lid(stream: &mut Stream, lamp: Vec3, way: DVec3, distance: f32) -> impl Shape + use<> {
    let gap = 64.0 * f64::from(draw::decade(stream, 0.0, 1.8)) * draw::ulp(2.0 * distance);
    let middle = lamp.as_dvec3() - gap * way;
    let (right, up) = way.any_orthonormal_pair();
    let side = 0.1 * f64::from(distance);
    let corner = |x: f64, y: f64| (middle + side * (x * right + y * up)).as_vec3();
    draw::triangle([corner(0.0, 1.0), corner(-0.9, -0.5), corner(0.9, -0.5)])
}

/// A quad, a triangle or a sphere through `place`, on whose outside `way` starts.
fn patch(stream: &mut Stream, place: Vec3, way: DVec3, size: f32) -> Option<Box<dyn Shape>> {
    let cosine = f64::from(draw::decade(stream, -3.0, 0.0));
    let normal = cosine * way + (1.0 - cosine * cosine).sqrt() * draw::across(stream, way);
    let right = draw::across(stream, normal);
    let (right, up) = (right.as_vec3() * size, normal.cross(right).as_vec3() * size);
    let corner = |x: f32, y: f32| place + x * right + y * up;
    Some(match draw::whole(stream, 0, 2) {
        0 => Box::new(Quad::new(corner(-0.6, -0.4), [1.1 * right, up])?),
        1 => {
            let corners = [corner(0.0, 0.8), corner(-0.9, -0.7), corner(0.8, -0.6)];
            Box::new(draw::triangle(corners))
        }
        _ => {
            let center = (place.as_dvec3() - f64::from(size) * normal).as_vec3();
            Box::new(Sphere { center, radius: size })
        }
    })
}

/// The surface at `place`, seen from along `way`.
fn struck(shape: &dyn Shape, place: Vec3, way: DVec3, distance: f32) -> Option<Hit> {
    let origin = place + 0.1 * distance * way.as_vec3();
    shape.hit(&Ray { origin, direction: -way.as_vec3() }, f32::INFINITY)
}

/// Whether the surface's front is clearly to be seen from `other`: rounding has turned the normal of
/// some small spheres, which then are in their own way.
fn faces(hit: &Hit, other: Vec3) -> bool {
    let toward = (other.as_dvec3() - hit.point.as_dvec3()).normalize();
    hit.geometric.as_dvec3().dot(toward) > 5e-4
}

pub(super) fn naive(trial: u64) -> bool {
    let Scene { shapes, floor, lamp, wall } = scene(trial);
    naive::report_visible(&shapes, floor.point, lamp, &mut Off) != wall.is_some()
}

pub(super) fn robust(trial: u64) -> bool {
    let Scene { shapes, floor, lamp, wall } = scene(trial);
    let end = wall.as_ref().map_or(End::Free(lamp), End::On);
    visible(&shapes[..], End::On(&floor), end, &mut Off) != wall.is_some()
}
