//! The exercises of chapter 5: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p shadows --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 5 has the story of
//! each.

use blinn_phong::light::Light;
use common::film::Color;
use glam::Vec3;
use ray_casting::shape::{Hit, Shape};
use ray_casting::sphere::Sphere;

/// Exercise 5.1, a question of its own: whether no sphere is between `point` and `lamp`.
///
/// Both are in the open, not on a sphere. [`Sphere::crossing`] says where a ray's line enters and
/// leaves, in lengths of its direction. See the section "A question of its own".
pub fn sees(spheres: &[Sphere], point: Vec3, lamp: Vec3) -> bool {
    let _ = (spheres, point, lamp);
    todo!("exercise 5.1")
}

/// Exercise 5.2, several lamps: the light that falls on a surface at `point` with this `normal`.
///
/// It is `ambient`, and of each lamp that `point` sees what arrives of it ([`Light::at`]) times the
/// cosine at which it arrives. Nothing comes from below. All lamps are [`Light::Point`]; you may use
/// your own `sees`. See the section "Several lamps".
pub fn light_at(
    spheres: &[Sphere],
    lamps: &[Light],
    ambient: Color,
    point: Vec3,
    normal: Vec3,
) -> Color {
    let _ = (spheres, lamps, ambient, point, normal);
    todo!("exercise 5.2")
}

/// Exercise 5.3, off the surface: the origin of a ray that leaves the surface in `direction`.
///
/// The point of the hit may be off by `hit.error` along each axis. The origin must be as far from
/// the point, along `hit.geometric` and on the side of `direction`, as the surface may be, and no
/// farther than by a thirty-second part and a few floats. See the section "As far as the point may
/// be wrong".
pub fn leave(hit: &Hit, direction: Vec3) -> Vec3 {
    let _ = (hit, direction);
    todo!("exercise 5.3")
}

/// Exercise 5.4, find the mistake: whether the surface at `hit` sees a point `lamp`, in a scene of
/// any size.
///
/// `naive::report_visible` is the published line. Of the three things that are wrong with it two
/// give wrong answers, where the scene is small or where it is large. You may use
/// [`crate::spawn::spawn`]. See the section "The report's line".
pub fn sees_lamp(shapes: &[Box<dyn Shape>], hit: &Hit, lamp: Vec3) -> bool {
    let _ = (shapes, hit, lamp);
    todo!("exercise 5.4")
}

/// Exercise 5.5, not through the surface: the cosine at which a lamp's light arrives at the side
/// that the eye sees, and 0 where none does.
///
/// `geometric` is the surface's own normal, `shading` the one it is shaded with; either may point
/// to either side, and both directions lead away from the surface. All have length 1. See the
/// section "Two normals".
pub fn arriving_cosine(geometric: Vec3, shading: Vec3, toward_eye: Vec3, toward_lamp: Vec3) -> f32 {
    let _ = (geometric, shading, toward_eye, toward_lamp);
    todo!("exercise 5.5")
}
