//! Edges as lines in space, and a little slack.

use glam::Vec3;
use ray_casting::ray::Ray;

use crate::intersect::{TriangleHit, TriangleTest};

/// On which side of each edge the ray passes, by Plücker's coordinates, with a slack of one unit in
/// the last place so that no crack is left. The slack lets in rays that pass far away from slim
/// triangles (hard case TR-05; it has been reported of real renderers).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plucker(pub Ray);

impl TriangleTest for Plucker {
    fn prepare(ray: &Ray) -> Option<Self> {
        Some(Self(*ray))
    }

    fn hit(&self, corners: &[Vec3; 3], t_max: f32) -> Option<TriangleHit> {
        let Ray { origin, direction } = self.0;
        let [a, b, c] = corners.map(|corner| corner - origin);
        let side = |p: Vec3, q: Vec3| (q - p).cross(q + p).dot(direction);
        let (u, v, w) = (side(b, c), side(c, a), side(a, b));
        let slack = f32::EPSILON * (u + v + w).abs();
        if u.min(v).min(w) < -slack && u.max(v).max(w) > slack {
            return None;
        }
        let normal = (b - a).cross(c - a);
        let t = normal.dot(a) / normal.dot(direction);
        let barycentric = Vec3::new(u, v, w) / (u + v + w);
        (t > 0.0 && t < t_max).then_some(TriangleHit { t, barycentric })
    }
}
