//! The formulas of many tutorials, which are right on paper.
//!
//! They are kept to be looked at, and as the negative controls of the hard cases. Nothing else
//! should use them.

use std::f32::consts::{PI, TAU};

use common::math;
use glam::{Vec2, Vec3};

use crate::camera::{Frame, View};
use crate::crossing::Crossing;
use crate::longitude::uv;
use crate::ray::Ray;
use crate::shape::{Hit, Shape};
use crate::sphere::Sphere;

/// A sphere by the quadratic formula as it stands in textbooks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaiveSphere(pub Sphere);

impl NaiveSphere {
    // ANCHOR: crossing
    /// Both roots of a t² + 2 h t + k = 0. |f|² swallows r² when the sphere is far away, and all
    /// but drowns in it when the sphere is huge and near.
    pub fn crossing(&self, ray: &Ray) -> Option<Crossing> {
        let (d, r) = (ray.direction, self.0.radius);
        let f = ray.origin - self.0.center;
        let a = d.dot(d);
        let h = f.dot(d);
        let k = f.dot(f) - r * r;
        let discriminant = h * h - a * k;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        Some(Crossing { enter: (-h - root) / a, leave: (-h + root) / a })
    }
    // ANCHOR_END: crossing
}

// ANCHOR: projected
/// Half the cure: the discriminant from the distance between centre and line, but k still as a
/// difference of squares. This is the form of Ray Tracing Gems, chapter 7.
pub fn projected_crossing(sphere: &Sphere, ray: &Ray) -> Option<Crossing> {
    let (d, r) = (ray.direction, sphere.radius);
    let f = ray.origin - sphere.center;
    let (a, b) = (d.dot(d), -f.dot(d));
    let l = f + (b / a) * d;
    let discriminant = r * r - l.dot(l);
    if !(discriminant >= 0.0) {
        return None;
    }
    let q = b + (a * discriminant).sqrt().copysign(b);
    let k = f.dot(f) - r * r;
    Crossing::sorted(k / q, q / a)
}
// ANCHOR_END: projected

impl Shape for NaiveSphere {
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let Self(sphere) = self;
        let t = self.crossing(ray)?.first(t_max)?;
        let point = ray.at(t);
        let normal = (point - sphere.center) / sphere.radius;
        Some(Hit { t, point, error: Vec3::ZERO, geometric: normal, normal, uv: uv(normal) })
    }
}

// ANCHOR: plane
/// Where the ray meets the plane through `point` with this `normal`, unless it is "parallel".
///
/// The 1e-8 has a unit that nobody wrote down: that of the ray's direction.
pub fn plane_distance(point: Vec3, normal: Vec3, ray: &Ray) -> Option<f32> {
    let denominator = ray.direction.dot(normal);
    if denominator.abs() < 1e-8 {
        return None;
    }
    let t = (point - ray.origin).dot(normal) / denominator;
    (t > 0.0).then_some(t)
}
// ANCHOR_END: plane

// ANCHOR: uv
/// Longitude and latitude with an arc cosine, which is NaN just above 1 and blind just below it.
pub fn sphere_uv(normal: Vec3) -> Vec2 {
    let longitude = math::atan2(-normal.z, normal.x);
    let latitude = math::acos(-normal.y);
    Vec2::new((longitude + PI) / TAU, latitude / PI)
}
// ANCHOR_END: uv

// ANCHOR: frame
/// The axes of a camera. When the view is all but straight up or down, the cross product is made of
/// rounding errors: it need not be at right angles to anything, and it may be 0 / 0.
pub fn frame(view: &View) -> Frame {
    let forward = (view.target - view.eye).normalize();
    let right = forward.cross(view.up).normalize();
    Frame { right, up: right.cross(forward), forward }
}
// ANCHOR_END: frame

// ANCHOR: report_ray
/// The camera ray of the report's §5.1: a point of the film minus the eye. The film's point is
/// given as if the eye were the origin, so the difference is right for that eye only.
pub fn report_ray(position: Vec2, size: Vec2, eye: Vec3, scale: f32) -> Ray {
    let x = (2.0 * position.x / size.x - 1.0) * scale * size.x / size.y;
    let y = (1.0 - 2.0 * position.y / size.y) * scale;
    Ray { origin: eye, direction: (Vec3::new(x, y, -1.0) - eye).normalize() }
}
// ANCHOR_END: report_ray
