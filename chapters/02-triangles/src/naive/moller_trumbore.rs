//! Möller and Trumbore's test as it was printed, and as it is often typed.

use glam::Vec3;
use ray_casting::ray::Ray;

use crate::intersect::{TriangleHit, TriangleTest};

/// How small the determinant may be in Möller and Trumbore's own listing.
pub const EPSILON: f32 = 1e-6;

// ANCHOR: moller_trumbore
/// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (Journal of Graphics
/// Tools 2(1), 1997).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MollerTrumbore(pub Ray);

impl TriangleTest for MollerTrumbore {
    fn prepare(ray: &Ray) -> Option<Self> {
        Some(Self(*ray))
    }

    #[inline]
    fn hit(&self, corners: &[Vec3; 3], t_max: f32) -> Option<TriangleHit> {
        let Ray { origin, direction } = self.0;
        let [a, b, c] = *corners;
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(ac);
        let determinant = ab.dot(p);
        if determinant.abs() < EPSILON {
            return None;
        }
        let inverse = 1.0 / determinant;
        let s = origin - a;
        let v = s.dot(p) * inverse;
        if !(0.0..=1.0).contains(&v) {
            return None;
        }
        let q = s.cross(ab);
        let w = direction.dot(q) * inverse;
        if w < 0.0 || v + w > 1.0 {
            return None;
        }
        let t = ac.dot(q) * inverse;
        let barycentric = Vec3::new(1.0 - v - w, v, w);
        (t > 0.0 && t < t_max).then_some(TriangleHit { t, barycentric })
    }
}
// ANCHOR_END: moller_trumbore

/// The same without its epsilon, and with the last question put the wrong way round: NaN is neither
/// too small nor too large, so it passes (hard cases TR-07 and TR-12).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unguarded(pub Ray);

impl TriangleTest for Unguarded {
    fn prepare(ray: &Ray) -> Option<Self> {
        Some(Self(*ray))
    }

    fn hit(&self, corners: &[Vec3; 3], t_max: f32) -> Option<TriangleHit> {
        let Ray { origin, direction } = self.0;
        let [a, b, c] = *corners;
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(ac);
        let inverse = 1.0 / ab.dot(p);
        let s = origin - a;
        let q = s.cross(ab);
        let (v, w) = (s.dot(p) * inverse, direction.dot(q) * inverse);
        let t = ac.dot(q) * inverse;
        if v < 0.0 || w < 0.0 || v + w > 1.0 || t <= 0.0 || t >= t_max {
            return None;
        }
        Some(TriangleHit { t, barycentric: Vec3::new(1.0 - v - w, v, w) })
    }
}
