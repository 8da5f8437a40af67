//! Boxes around shapes.

use glam::Vec3;
use ray_casting::direction::{cross, unit};
use ray_casting::quad::Quad;
use ray_casting::rounding::gamma;
use ray_casting::sphere::Sphere;
use triangles::mesh::Mesh;

use crate::aabb::Aabb;

// ANCHOR: bounded
/// A thing that has a place and an end, so that a box can be drawn around it.
///
/// An infinite plane has no end, and so no box: it is no `Bounded`, and has to be asked by every ray.
pub trait Bounded {
    /// A box around every point at which a ray can hit it. Empty for what no ray can hit.
    fn bounds(&self) -> Aabb;
}
// ANCHOR_END: bounded

// ANCHOR: triangle
/// A triangle's three corners. No ray hits one whose corners are not all finite.
impl Bounded for [Vec3; 3] {
    #[inline]
    fn bounds(&self) -> Aabb {
        let finite = self.iter().all(|corner| corner.is_finite());
        if finite { Aabb::of_points(*self) } else { Aabb::EMPTY }
    }
}

/// The corners of its triangles; vertices that no triangle has do not count.
impl Bounded for Mesh {
    fn bounds(&self) -> Aabb {
        let triangles = (0..self.triangles.len()).map(|index| self.corners(index).bounds());
        triangles.fold(Aabb::EMPTY, Aabb::union)
    }
}
// ANCHOR_END: triangle

// ANCHOR: sphere
/// No ray hits a sphere whose radius is not above 0, or not finite.
impl Bounded for Sphere {
    fn bounds(&self) -> Aabb {
        let usable = self.radius > 0.0 && self.radius.is_finite();
        let center = if usable { self.center } else { Vec3::NAN };
        Aabb::of_points([center]).widened(Vec3::splat(self.radius))
    }
}
// ANCHOR_END: sphere

// ANCHOR: quad
/// Its four corners, and what the quad's own roundings may add: they grow with its coordinates, and
/// with how slanted it is.
impl Bounded for Quad {
    fn bounds(&self) -> Aabb {
        let corners = self.corners();
        let bounds = Aabb::of_points(corners);
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        bounds.widened(Vec3::splat(gamma(32) * largest * slant(corners)))
    }
}

/// 1 for a rectangle; the inverse of the sine between the edges.
fn slant([corner, first, _, second]: [Vec3; 4]) -> f32 {
    let sides = [first - corner, second - corner].map(|edge| unit(edge).unwrap_or(Vec3::X));
    1.0 / cross(sides[0], sides[1]).length()
}
// ANCHOR_END: quad
