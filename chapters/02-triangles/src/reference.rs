//! The f64 reference: the same question with 29 more bits for every intermediate result.

use glam::{DVec3, Vec3};
use ray_casting::ray::Ray;

use crate::intersect::{TriangleHit, TriangleTest};

/// Möller and Trumbore's test in `f64`, from the same `f32` inputs and without their epsilon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleRay {
    origin: DVec3,
    direction: DVec3,
}

impl TriangleTest for DoubleRay {
    fn prepare(ray: &Ray) -> Option<Self> {
        let usable = ray.origin.is_finite() && ray.direction.is_finite();
        (usable && ray.direction != Vec3::ZERO)
            .then(|| Self { origin: ray.origin.as_dvec3(), direction: ray.direction.as_dvec3() })
    }

    #[inline]
    fn hit(&self, corners: &[Vec3; 3], t_max: f32) -> Option<TriangleHit> {
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        let (ab, ac) = (b - a, c - a);
        let p = self.direction.cross(ac);
        let determinant = ab.dot(p);
        let s = self.origin - a;
        let v = s.dot(p) / determinant;
        if !(0.0..=1.0).contains(&v) {
            return None;
        }
        let q = s.cross(ab);
        let w = self.direction.dot(q) / determinant;
        let u = 1.0 - v - w;
        if !(w >= 0.0 && u >= 0.0) {
            return None;
        }
        let t = (ac.dot(q) / determinant) as f32;
        let barycentric = DVec3::new(u, v, w).as_vec3();
        (t > 0.0 && t < t_max).then_some(TriangleHit { t, barycentric })
    }
}
