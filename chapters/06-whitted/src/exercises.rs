//! The exercises of chapter 6: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p whitted --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 6 has the story of
//! each.

use common::film::Color;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::sphere::Sphere;

/// Exercise 6.1, a mirror: the direction that a mirror turns `incoming` into.
///
/// Both have length 1. The normal may point to either side of the mirror. See the section "Which way
/// a mirror sends light".
pub fn mirror_direction(incoming: Vec3, normal: Vec3) -> Vec3 {
    let _ = (incoming, normal);
    todo!("exercise 6.1")
}

/// What a ray meets on its way from mirror to mirror.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Met {
    /// The radiance the surface sends by itself.
    pub light: f32,
    /// What it returns of the radiance that its mirror ray brings, in [0, 1].
    pub mirror: f32,
}

/// Exercise 6.2, depth and cut-off: what a ray brings that meets `surfaces` in this order, and
/// nothing after the last.
///
/// A mirror ray is followed only if it is at most the `depth`-th, and only if more than `cutoff` of
/// its radiance reaches the eye. See the section "Where following ends".
pub fn along(surfaces: &[Met], depth: u32, cutoff: f32) -> f32 {
    let _ = (surfaces, depth, cutoff);
    todo!("exercise 6.2")
}

/// A ball that glows and mirrors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its surface.
    pub sphere: Sphere,
    /// The radiance it sends by itself, in all directions.
    pub light: Color,
    /// What it returns of the radiance that its mirror ray brings.
    pub mirror: Color,
}

/// Exercise 6.3, a picture with mirrors: the radiance that `ray` brings from among the balls.
///
/// Where it meets none it brings `background`. At most `depth` mirror rays are followed from one to
/// the next. You may use [`ray_casting::shape::nearest`] or your own search, and
/// [`crate::mirror::mirrored`]. The check draws a picture with your function and compares. See the
/// section "A surface's own light, and the mirror's".
pub fn among(balls: &[Ball], background: Color, ray: &Ray, depth: u32) -> Color {
    let _ = (balls, background, ray, depth);
    todo!("exercise 6.3")
}

/// A surface with any number of branches.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The radiance it sends by itself.
    pub light: f64,
    /// The numbers of the nodes that its branches meet, and the weight of each.
    pub branches: Vec<(usize, f64)>,
}

/// Exercise 6.4, a list in place of the stack: the light of node 0 and all its branches, and theirs.
///
/// `meet` gives a node by its number. Follow all branches to their ends. Your function must not call
/// itself, nor any that does: some rows are a hundred thousand nodes long, and the check looks at the
/// stack. See the section "The same as a loop".
pub fn total(meet: &dyn Fn(usize) -> Node) -> f64 {
    let _ = meet;
    todo!("exercise 6.4")
}

/// Exercise 6.5, how deep is deep enough: the smallest depth at which two facing mirrors show all of
/// their light but at most the part `missing` of it.
///
/// Each returns `mirror` of what the other sends, in (0, 1), and sends the same light by itself. All
/// of their light is what an infinite depth would show. See the section "A series".
pub fn depth_needed(mirror: f64, missing: f64) -> u32 {
    let _ = (mirror, missing);
    todo!("exercise 6.5")
}

/// Exercise 6.6, find the mistake: where the ray of a mirror starts.
///
/// `naive::framework_origin` is the published line of GAMES101's framework. Write it right: the
/// point moved by `epsilon` along the normal, to the side to which the ray goes. (How large the
/// step has to be is chapter 5's matter; here it is given.) See the section "Where the ray starts".
pub fn mirror_origin(point: Vec3, normal: Vec3, direction: Vec3, epsilon: f32) -> Vec3 {
    let _ = (point, normal, direction, epsilon);
    todo!("exercise 6.6")
}
