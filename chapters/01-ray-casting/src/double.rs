//! The sphere in `f64`: twice the digits, the same `f32` inputs.

use glam::DVec3;

use crate::crossing::Crossing;
use crate::longitude::uv;
use crate::ray::Ray;
use crate::rounding::gamma;
use crate::shape::{Hit, Shape};
use crate::sphere::Sphere;

/// Where a line crosses a sphere, to 53 bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exact {
    /// The smaller distance, in lengths of the ray's direction.
    pub enter: f64,
    /// The larger distance.
    pub leave: f64,
    /// From the centre to the line.
    pub distance: f64,
}

// ANCHOR: crossing
/// The stable formula of [`Sphere::crossing`] in `f64`, for the sphere with this radius instead of
/// its own: what every other formula is held against. NaN where the line misses.
pub fn crossing(sphere: &Sphere, ray: &Ray, radius: f64) -> Exact {
    let d = ray.direction.as_dvec3();
    let f = ray.origin.as_dvec3() - sphere.center.as_dvec3();
    let (a, b) = (d.dot(d), -f.dot(d));
    let distance = (f + b / a * d).length();
    let root = (a * (radius - distance) * (radius + distance)).sqrt();
    let q = b + root.copysign(b);
    let (first, second) = ((f.length() - radius) * (f.length() + radius) / q, q / a);
    Exact { enter: first.min(second), leave: first.max(second), distance }
}
// ANCHOR_END: crossing

/// A sphere whose hits are computed by the textbook's formula, in `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleSphere(pub Sphere);

impl DoubleSphere {
    // ANCHOR: textbook
    /// Where the ray's line enters and leaves the sphere.
    pub fn crossing(&self, ray: &Ray) -> Option<Crossing> {
        let Self(sphere) = self;
        let radius = f64::from(sphere.radius);
        let d = ray.direction.as_dvec3();
        let f = ray.origin.as_dvec3() - sphere.center.as_dvec3();
        let (a, h) = (d.dot(d), f.dot(d));
        let discriminant = h * h - a * (f.dot(f) - radius * radius);
        if !(discriminant >= 0.0 && radius > 0.0) {
            return None;
        }
        let root = discriminant.sqrt();
        Crossing::sorted(((-h - root) / a) as f32, ((-h + root) / a) as f32)
    }
    // ANCHOR_END: textbook
}

impl Shape for DoubleSphere {
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let Self(sphere) = self;
        let t = self.crossing(ray)?.first(t_max)?;
        let center = sphere.center.as_dvec3();
        let outward: DVec3 =
            ray.origin.as_dvec3() - center + f64::from(t) * ray.direction.as_dvec3();
        let normal = outward / outward.length();
        let point = (center + f64::from(sphere.radius) * normal).as_vec3();
        let normal = normal.as_vec3();
        // Rounded once, from numbers with twice the digits.
        let error = gamma(2) * point.abs();
        Some(Hit { t, point, error, geometric: normal, normal, uv: uv(normal) })
    }
}
