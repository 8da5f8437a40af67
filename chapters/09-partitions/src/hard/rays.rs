//! Rays that are hard for one structure or another.

use boxes::aabb::Aabb;
use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::scenes::{Corners, Scene};

/// How many kinds of rays there are.
pub const KINDS: u64 = 10;

/// A ray of kind `kind` at a scene, if one came out that has a direction.
pub fn ray(scene: &Scene, kind: u64, stream: &mut Stream) -> Option<Ray> {
    let bounds = around(scene);
    let size = bounds.size().max_element();
    let origin = outside(&bounds, 1.5 * size, stream);
    match kind {
        // At any point of the box.
        0 => Ray::new(origin, inside(&bounds, stream) - origin),
        1 => Ray::new(origin, on_edge(scene, stream) - origin),
        2 => Ray::new(origin, corner(scene, stream) - origin),
        // From within.
        3 => {
            let origin = inside(&bounds, stream);
            Ray::new(origin, on_edge(scene, stream) - origin)
        }
        4 => along_an_axis(corner(scene, stream), origin, stream),
        // In a plane across an axis, along the borders of cells.
        5 => {
            let target = corner(scene, stream);
            let axis = stream.bits() as usize % 3;
            let mut origin = origin;
            origin[axis] = target[axis];
            Ray::new(origin, target - origin)
        }
        // From very far away.
        6 => {
            let power = stream.between(0.0, 23.0) as u32;
            let origin = outside(&bounds, size * (1u32 << power) as f32, stream);
            Ray::new(origin, on_edge(scene, stream) - origin)
        }
        // A direction of any length, some of its components next to nothing.
        7 => {
            let target = on_edge(scene, stream);
            let factor = f32::from_bits((stream.bits() % 100 + 80) << 23);
            let mut direction = factor * (target - origin);
            if stream.uniform() < 0.5 {
                direction[stream.bits() as usize % 3] *= 1e-38;
            }
            Some(Ray { origin, direction })
        }
        // From a point of a triangle.
        8 => {
            let origin = on_edge(scene, stream);
            Ray::new(origin, corner(scene, stream) - origin)
        }
        // Along a triangle's edge.
        _ => {
            let [a, b, _] = some_triangle(scene, stream);
            let origin = a - 2.0 * (b - a);
            Ray::new(origin, b - origin)
        }
    }
}

/// A limit for hits: none as a rule.
pub fn t_max(stream: &mut Stream, size: f32) -> f32 {
    if stream.uniform() < 0.8 { f32::INFINITY } else { size * stream.between(0.0, 3.0) }
}

/// The box around the triangles of the scene that are finite.
pub fn around(scene: &Scene) -> Aabb {
    Aabb::of_points(
        scene.triangles.iter().filter(|it| it.iter().all(|it| it.is_finite())).flatten().copied(),
    )
}

fn uniform(stream: &mut Stream) -> Vec3 {
    let x = stream.uniform();
    let y = stream.uniform();
    Vec3::new(x, y, stream.uniform())
}

fn inside(bounds: &Aabb, stream: &mut Stream) -> Vec3 {
    bounds.min + uniform(stream) * bounds.size()
}

fn outside(bounds: &Aabb, distance: f32, stream: &mut Stream) -> Vec3 {
    let direction = 2.0 * uniform(stream) - Vec3::ONE;
    bounds.center() + distance * direction
}

fn some_triangle(scene: &Scene, stream: &mut Stream) -> Corners {
    let finite = |it: &&Corners| it.iter().all(|corner| corner.is_finite());
    let at = stream.bits() as usize % scene.triangles.len();
    let all = scene.triangles[at..].iter().chain(&scene.triangles);
    all.copied().find(|it| finite(&it)).unwrap_or_default()
}

fn corner(scene: &Scene, stream: &mut Stream) -> Vec3 {
    some_triangle(scene, stream)[stream.bits() as usize % 3]
}

fn on_edge(scene: &Scene, stream: &mut Stream) -> Vec3 {
    let [a, b, _] = some_triangle(scene, stream);
    a + stream.uniform() * (b - a)
}

/// Through `target` along an axis; the zeros of its direction have either sign.
fn along_an_axis(target: Vec3, from: Vec3, stream: &mut Stream) -> Option<Ray> {
    let axis = stream.bits() as usize % 3;
    let mut origin = target;
    origin[axis] = from[axis];
    let zero = |stream: &mut Stream| if stream.uniform() < 0.5 { 0.0 } else { -0.0 };
    let mut direction = Vec3::new(zero(stream), zero(stream), zero(stream));
    direction[axis] = (target[axis] - from[axis]).signum();
    Some(Ray { origin, direction })
}
