//! One good answer to each exercise.

use common::math;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::sphere::Sphere;

use crate::cases::{Disk, Pixel, Quadratic, Seen};

pub(super) fn pixel_direction(pixel: &Pixel) -> Vec3 {
    let (width, height) = (pixel.width as f32, pixel.height as f32);
    let scale = math::tan(pixel.vertical_fov.to_radians() / 2.0);
    let x = (2.0 * (pixel.x as f32 + 0.5) / width - 1.0) * scale * width / height;
    let y = (1.0 - 2.0 * (pixel.y as f32 + 0.5) / height) * scale;
    Vec3::new(x, y, -1.0).normalize()
}

pub(super) fn hit_sphere(sphere: &Sphere, ray: &Ray) -> Option<f32> {
    let f = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let h = f.dot(ray.direction);
    let discriminant = h * h - a * (f.dot(f) - sphere.radius * sphere.radius);
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    [(-h - root) / a, (-h + root) / a].into_iter().find(|&t| t > 0.0)
}

pub(super) fn first_seen(spheres: &[Sphere], ray: &Ray) -> Option<usize> {
    let mut first = None;
    let mut limit = f32::INFINITY;
    for (index, sphere) in spheres.iter().enumerate() {
        if let Some(t) = hit_sphere(sphere, ray).filter(|&t| t < limit) {
            limit = t;
            first = Some(index);
        }
    }
    first
}

pub(super) fn hit_disk(disk: &Disk) -> Option<f32> {
    let t = (disk.center - disk.ray.origin).dot(disk.normal) / disk.ray.direction.dot(disk.normal);
    let from_center = disk.ray.at(t) - disk.center;
    (t > 0.0 && t < f32::INFINITY && from_center.length() <= disk.radius).then_some(t)
}

pub(super) fn roots(case: &Quadratic) -> Option<[f32; 2]> {
    let &Quadratic { a, h, c } = case;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let q = -(h + discriminant.sqrt().copysign(h));
    let (first, second) = (q / a, c / q);
    Some([first.min(second), first.max(second)])
}

pub(super) fn look_at_direction(seen: &Seen) -> Vec3 {
    let forward = (seen.target - seen.eye).normalize();
    let right = forward.cross(Vec3::Y).normalize();
    let up = right.cross(forward);
    let x = (2.0 * seen.position.x - seen.size.x) / seen.size.y * seen.scale;
    let y = (seen.size.y - 2.0 * seen.position.y) / seen.size.y * seen.scale;
    (x * right + y * up + forward).normalize()
}
