//! The sheared test without its safeguards.

use glam::Vec3;
use ray_casting::ray::Ray;

use crate::intersect::{TriangleHit, TriangleTest};
use crate::watertight::ShearedRay;

/// The test of Woop, Benthin and Wald with all its sums in `f32`, and without asking whether the
/// triangle has an area or the result is a number (hard cases TR-06 and TR-08).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BareShear(ShearedRay);

impl TriangleTest for BareShear {
    fn prepare(ray: &Ray) -> Option<Self> {
        ShearedRay::prepare(ray).map(Self)
    }

    fn hit(&self, corners: &[Vec3; 3], t_max: f32) -> Option<TriangleHit> {
        let [a, b, c] = corners.map(|corner| self.0.shear(corner));
        let edge = |p: Vec3, q: Vec3| p.x * q.y - p.y * q.x;
        let (u, v, w) = (edge(b, c), edge(c, a), edge(a, b));
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let determinant = u + v + w;
        if determinant == 0.0 {
            return None;
        }
        let t = (u * a.z + v * b.z + w * c.z) / (determinant * self.0.advance);
        if t <= 0.0 || t >= t_max {
            return None;
        }
        Some(TriangleHit { t, barycentric: Vec3::new(u, v, w) / determinant })
    }
}
