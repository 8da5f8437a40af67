//! The exercises of chapter 1: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p ray-casting --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 1 has the story of
//! each.

use glam::{Vec2, Vec3};

use crate::ray::Ray;
use crate::sphere::Sphere;

/// Exercise 1.1, one ray for each pixel: the direction, of length 1, through the centre of a pixel.
///
/// The eye is at the origin and looks along -z; x is right, y is up. The pixel is in column `x`
/// from the left and row `y` from the top, both from 0, of a picture `width` by `height` pixels
/// large. `vertical_fov` is the angle between the picture's top and bottom, in degrees.
/// [`common::math::tan`] is the tangent. See the section "From a pixel to a ray".
pub fn pixel_direction(x: u32, y: u32, width: u32, height: u32, vertical_fov: f32) -> Vec3 {
    let _ = (x, y, width, height, vertical_fov);
    todo!("exercise 1.1")
}

/// Exercise 1.2, the quadratic: the smallest `t` above 0 at which the ray is on the sphere.
///
/// The ray may start anywhere, inside the sphere too, and its direction may have any length. None
/// when the sphere is missed or wholly behind the ray's origin. The textbook's formula will do. See
/// the section "Where a ray meets a sphere".
pub fn hit_sphere(sphere: &Sphere, ray: &Ray) -> Option<f32> {
    let _ = (sphere, ray);
    todo!("exercise 1.2")
}

/// Exercise 1.3, what hides what: which of the spheres the ray meets first, by its place in the
/// list.
///
/// None when it meets none. You may use [`Sphere::crossing`] or your own `hit_sphere`. The check
/// draws a picture with your function and compares. See the section "The nearest hit".
pub fn first_seen(spheres: &[Sphere], ray: &Ray) -> Option<usize> {
    let _ = (spheres, ray);
    todo!("exercise 1.3")
}

/// Exercise 1.4, a new shape: where a ray meets a flat disk, from whichever side.
///
/// The disk has a centre, a radius, and a normal of any length but 0; the ray's direction may have
/// any length, too. Gives `t` above 0, in lengths of the direction. A ray that runs beside the disk
/// or in its plane misses. See the section "Planes and quads".
pub fn hit_disk(center: Vec3, normal: Vec3, radius: f32, ray: &Ray) -> Option<f32> {
    let _ = (center, normal, radius, ray);
    todo!("exercise 1.4")
}

/// Exercise 1.5, no digit lost: both roots of a t² + 2 h t + k = 0, the smaller first.
///
/// `a` is above 0. None when there are no real roots. The discriminant h² - a k may be computed as
/// it stands: in these cases it doesn't cancel. But each root must be right to 1 in 10^6, even when
/// one is ten million times the other. See the section "Two roots, no subtraction".
pub fn roots(a: f32, h: f32, k: f32) -> Option<[f32; 2]> {
    let _ = (a, h, k);
    todo!("exercise 1.5")
}

/// Exercise 1.6, find the mistake: the report's camera for an eye anywhere.
///
/// `naive::report_ray` is the published line, right for an eye at the origin that looks along -z
/// and for no other. Write it for any `eye` and `target`. `position` is a point of the film in
/// pixels from its top left corner, `size` the film's width and height in pixels, `scale` half the
/// film's height one unit before the eye. Up is as near to +y as can be; the target is never
/// straight above or below. Gives a direction of length 1. See the section "A camera anywhere".
pub fn look_at_direction(position: Vec2, size: Vec2, scale: f32, eye: Vec3, target: Vec3) -> Vec3 {
    let _ = (position, size, scale, eye, target);
    todo!("exercise 1.6")
}
