//! The solutions.

use boxes::aabb::Aabb;
use glam::Vec3;
use ray_casting::ray::Ray;

/// Exercise 8.1.
pub(crate) fn smallest_box(points: &[Vec3]) -> Option<Aabb> {
    let mut finite = points.iter().copied().filter(|point| point.is_finite());
    let first = finite.next()?;
    Some(finite.fold(Aabb { min: first, max: first }, |bounds, point| Aabb {
        min: bounds.min.min(point),
        max: bounds.max.max(point),
    }))
}

/// Exercise 8.2.
pub(crate) fn surface_area(bounds: &Aabb) -> f32 {
    let Vec3 { x, y, z } = bounds.max - bounds.min;
    let empty = x < 0.0 || y < 0.0 || z < 0.0;
    if empty { 0.0 } else { 2.0 * (x * y + y * z + z * x) }
}

/// Exercise 8.3.
pub(crate) fn enter(ray: &Ray, bounds: &Aabb, t_max: f32) -> Option<f32> {
    let a = (bounds.min - ray.origin) / ray.direction;
    let b = (bounds.max - ray.origin) / ray.direction;
    let enter = a.min(b).max_element().max(0.0);
    let leave = a.max(b).min_element().min(t_max);
    (enter <= leave).then_some(enter)
}

/// Exercise 8.4.
pub(crate) fn meets(ray: &Ray, bounds: &Aabb) -> bool {
    let (mut enter, mut leave) = (0.0, f32::INFINITY);
    for axis in 0..3 {
        let inverse = 1.0 / ray.direction[axis];
        let a = (bounds.min[axis] - ray.origin[axis]) * inverse;
        let b = (bounds.max[axis] - ray.origin[axis]) * inverse;
        // NaN is neither: the faces it came from don't count.
        let (near, far) = if inverse < 0.0 { (b, a) } else { (a, b) };
        enter = if near > enter { near } else { enter };
        leave = if far < leave { far } else { leave };
    }
    enter <= leave
}

/// Exercise 8.5.
pub(crate) fn pad(origin: Vec3, scene: &Aabb) -> f32 {
    let farthest = (scene.min - origin).abs().max((scene.max - origin).abs());
    8.0 * f32::EPSILON * farthest.max_element()
}
