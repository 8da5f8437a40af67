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

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::quad::Quad;
    use ray_casting::ray::Ray;
    use ray_casting::shape::Shape;
    use ray_casting::sphere::Sphere;
    use triangles::bumpy;
    use triangles::mesh::Mesh;

    use super::Bounded;
    use crate::aabb::Aabb;
    use crate::slab::BoxRay;

    fn point(stream: &mut Stream, side: f32) -> Vec3 {
        let x = stream.between(-side, side);
        let y = stream.between(-side, side);
        Vec3::new(x, y, stream.between(-side, side))
    }

    /// Whether the shape's hit comes before the ray is in its box, or without that; None for a miss.
    fn is_lost(shape: &(impl Shape + Bounded), ray: &Ray) -> Option<bool> {
        let t = shape.hit(ray, f32::INFINITY)?.t;
        let bounds = shape.bounds();
        let enter = BoxRay::new(ray, &bounds).enter(&bounds, t);
        Some(!enter.is_some_and(|enter| enter <= t))
    }

    /// Rays that graze spheres where they touch their boxes, from near and far.
    #[test]
    fn whatever_hits_a_sphere_hits_its_box() {
        let mut hits = 0;
        for trial in 0..300_000 {
            let mut stream = Stream::of_trial(861, trial);
            let decade =
                |stream: &mut Stream, low, high| common::math::pow(10.0, stream.between(low, high));
            let radius = decade(&mut stream, -3.0, 3.0);
            let sphere = Sphere { center: point(&mut stream, 10.0), radius };
            // Beside the middle of a face, and along it but for a little.
            let axis = trial as usize % 3;
            let mut touch = sphere.center;
            touch[axis] += if trial.is_multiple_of(2) { radius } else { -radius };
            let mut direction = point(&mut stream, 1.0);
            direction[axis] *= decade(&mut stream, -9.0, 0.0);
            let target = touch + point(&mut stream, 1e-6 * radius);
            let ray =
                Ray { origin: target - decade(&mut stream, -2.0, 3.0) * direction, direction };
            if let Some(lost) = is_lost(&sphere, &ray) {
                assert!(!lost, "{trial}: {sphere:?} {ray:?}");
                hits += 1;
            }
        }
        assert!(hits > 50_000, "{hits}");
    }

    /// Rays at edges and corners of quads, slanted and not.
    #[test]
    fn whatever_hits_a_quad_hits_its_box() {
        let mut hits = 0;
        for trial in 0..300_000 {
            let mut stream = Stream::of_trial(862, trial);
            let corner = point(&mut stream, 5.0);
            let mut edges = [point(&mut stream, 3.0), point(&mut stream, 3.0)];
            if trial.is_multiple_of(3) {
                // Along two axes, as the walls of a room.
                let axis = trial as usize % 9 / 3;
                edges = [0, 1].map(|turn| {
                    let mut along = Vec3::ZERO;
                    along[(axis + turn) % 3] = edges[turn].x;
                    along
                });
            }
            let Some(quad) = Quad::new(corner, edges) else { continue };
            let share = [0.0, 1.0, stream.uniform()][trial as usize % 3];
            let target = corner + share * edges[0] + stream.uniform() * edges[1];
            let origin = point(&mut stream, if trial.is_multiple_of(2) { 9.0 } else { 900.0 });
            let ray = Ray { origin, direction: target - origin };
            if let Some(lost) = is_lost(&quad, &ray) {
                assert!(!lost, "{trial}: {quad:?} {ray:?}");
                hits += 1;
            }
        }
        assert!(hits > 50_000, "{hits}");
    }

    #[test]
    fn boxes_by_hand() {
        let sphere = Sphere { center: Vec3::new(1.0, -2.0, 3.0), radius: 0.5 };
        let bounds = sphere.bounds();
        assert!((bounds.min - Vec3::new(0.5, -2.5, 2.5)).abs().max_element() < 1e-6);
        assert!((bounds.max - Vec3::new(1.5, -1.5, 3.5)).abs().max_element() < 1e-6);
        let quad = Quad::new(Vec3::ONE, [Vec3::X * 2.0, Vec3::new(1.0, 0.0, -3.0)]);
        let bounds = quad.expect("it has an area").bounds();
        assert!((bounds.min - Vec3::new(1.0, 1.0, -2.0)).abs().max_element() < 1e-4);
        assert!((bounds.max - Vec3::new(4.0, 1.0, 1.0)).abs().max_element() < 1e-4);
        let corners = [Vec3::new(3.0, 0.0, 1.0), Vec3::new(-1.0, 2.0, 1.0), Vec3::ZERO];
        let expected = Aabb { min: Vec3::new(-1.0, 0.0, 0.0), max: Vec3::new(3.0, 2.0, 1.0) };
        assert_eq!(corners.bounds(), expected);
    }

    #[test]
    fn a_mesh_s_box_is_that_of_its_triangles() {
        let mut mesh = bumpy::sphere(300);
        let extent = mesh.extent().expect("it has triangles");
        mesh.positions.push(Vec3::splat(100.0));
        let bounds = mesh.bounds();
        assert_eq!((bounds.min, bounds.max), (extent.low, extent.high));
        assert!(Mesh::default().bounds().is_empty());
    }

    #[test]
    fn what_no_ray_can_hit_has_an_empty_box() {
        for radius in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            assert!(Sphere { center: Vec3::ONE, radius }.bounds().is_empty(), "{radius}");
        }
        assert!(Sphere { center: Vec3::NAN, radius: 1.0 }.bounds().is_empty());
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert!([Vec3::X, Vec3::Y, Vec3::Z.with_y(bad)].bounds().is_empty(), "{bad}");
        }
    }
}
