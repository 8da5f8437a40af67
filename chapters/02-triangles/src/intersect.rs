//! What a ray-triangle test answers, and what every such test can do.

use glam::Vec3;
use ray_casting::ray::Ray;

// ANCHOR: hit
/// Where a ray meets a triangle with the corners a, b and c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// How far along the ray, in lengths of its direction: finite and above 0.
    pub t: f32,
    /// The weights of a, b and c in the point that was hit: none negative, sum 1.
    pub barycentric: Vec3,
}
// ANCHOR_END: hit

// ANCHOR: test
/// A ray, made ready to be tested against many triangles.
pub trait TriangleTest: Copy + Sync {
    /// Does the work that is the same for every triangle. None when the ray has no direction, or
    /// isn't finite: it hits nothing.
    fn prepare(ray: &Ray) -> Option<Self>;

    /// The hit with the triangle between these corners, if it has `0 < t < t_max`.
    fn hit(&self, corners: &[Vec3; 3], t_max: f32) -> Option<TriangleHit>;
}
// ANCHOR_END: test
