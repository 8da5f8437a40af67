//! The flat piece with four edges: a floor, a wall, a lamp.

use glam::{Vec2, Vec3};

use crate::direction::{cross, unit};
use crate::plane::Plane;
use crate::ray::Ray;
use crate::rounding::{Placed, gamma};
use crate::shape::{Hit, Shape};

/// A parallelogram: a corner, and the two edges that leave it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    corner: Vec3,
    edges: [Vec3; 2],
    plane: Plane,
    /// The dot product of `along[0]` with a vector from the corner is how many times the first edge
    /// goes into it, whatever it has of the second; `along[1]` for the other.
    along: [Vec3; 2],
    /// How far the end of each edge is from the plane, whose normal had to be rounded.
    lift: Vec2,
}

impl Quad {
    // ANCHOR: new
    /// The parallelogram between two edges that start in `corner`. Its front is where the first
    /// edge turns to the second counterclockwise.
    ///
    /// None when the edges have no area between them, or something isn't finite.
    pub fn new(corner: Vec3, edges: [Vec3; 2]) -> Option<Self> {
        let sides = [unit(edges[0])?, unit(edges[1])?];
        let plane = Plane::new(corner, cross(sides[0], sides[1]))?;
        let along = [
            measure(edges[0], sides[1].cross(plane.normal())),
            measure(edges[1], plane.normal().cross(sides[0])),
        ];
        let usable = along.iter().all(|along| along.is_finite());
        let lift = Vec2::from(edges.map(|edge| height(edge, plane.normal())));
        usable.then_some(Self { corner, edges, plane, along, lift })
    }
    // ANCHOR_END: new

    // ANCHOR: place
    /// Where in the parallelogram a point of its plane lies: (0, 0) in the corner, (1, 1) opposite.
    fn place(&self, point: Vec3) -> Vec2 {
        let from_corner = point - self.corner;
        Vec2::new(from_corner.dot(self.along[0]), from_corner.dot(self.along[1]))
    }
    // ANCHOR_END: place

    // ANCHOR: point
    /// The point at the place `uv`.
    ///
    /// It is three roundings of the corner and of the two steps from there, and as far from the
    /// plane as the edges are. Asked again, the plane measures its height from the corner: four
    /// roundings of both steps.
    fn point(&self, uv: Vec2) -> Placed {
        let (first, second) = (uv.x * self.edges[0], uv.y * self.edges[1]);
        let point = self.corner + first + second;
        let rounded = gamma(4) * self.corner.abs() + gamma(8) * (first.abs() + second.abs());
        let lifted = uv.dot(self.lift) * self.plane.normal().abs();
        Placed { point, error: rounded + lifted }
    }
    // ANCHOR_END: point
}

/// How far the tip of `edge` is from a plane through its other end, a little rounded up.
fn height(edge: Vec3, normal: Vec3) -> f32 {
    (1.000_01 * edge.as_dvec3().dot(normal.as_dvec3()).abs()) as f32
}

/// The vector along `across` whose dot product with `edge` is 1.
fn measure(edge: Vec3, across: Vec3) -> Vec3 {
    across / edge.dot(across)
}

// ANCHOR: hit
impl Shape for Quad {
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let t = self.plane.distance(ray, t_max)?;
        let uv = self.place(ray.at(t));
        let inside = uv.cmpge(Vec2::ZERO).all() && uv.cmple(Vec2::ONE).all();
        let normal = self.plane.normal();
        let Placed { point, error } = self.point(uv);
        inside.then_some(Hit { t, point, error, geometric: normal, normal, uv })
    }

    fn hides_itself(&self, _eye: Vec3) -> bool {
        false
    }
}
// ANCHOR_END: hit

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::{Vec2, Vec3};

    use super::Quad;
    use crate::ray::Ray;
    use crate::shape::Shape;

    /// Two wide, three deep, and slanted.
    fn slanted() -> Quad {
        let edges = [Vec3::new(2.0, 0.0, 0.0), Vec3::new(1.0, 0.0, -3.0)];
        Quad::new(Vec3::new(-1.0, -4.0, -5.0), edges).expect("an area")
    }

    fn down(x: f32, z: f32) -> Ray {
        Ray { origin: Vec3::new(x, 0.0, z), direction: Vec3::NEG_Y }
    }

    #[test]
    fn a_hit_by_hand() {
        // Half along the first edge and two thirds along the second.
        let hit = slanted().hit(&down(-1.0 + 1.0 + 2.0 / 3.0, -7.0), 9.0).expect("a hit");
        assert!((hit.uv - Vec2::new(0.5, 2.0 / 3.0)).length() < 1e-6);
        assert!((hit.point - Vec3::new(2.0 / 3.0, -4.0, -7.0)).length() < 1e-6);
        assert_eq!((hit.t, hit.normal), (4.0, Vec3::Y));
    }

    #[test]
    fn inside_is_what_two_edges_reach() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(23, trial);
            let (u, v) = (stream.between(-0.5, 1.5), stream.between(-0.5, 1.5));
            let hit = slanted().hit(&down(-1.0 + 2.0 * u + v, -5.0 - 3.0 * v), f32::INFINITY);
            let inside = [u, v].iter().all(|number| (0.0..=1.0).contains(number));
            let on_edge = [u, v, 1.0 - u, 1.0 - v].iter().any(|number| number.abs() < 1e-6);
            assert!(on_edge || hit.is_some() == inside, "{u} {v}");
        }
    }

    #[test]
    fn no_area_no_quad() {
        let quad = |edges| Quad::new(Vec3::ONE, edges);
        assert_eq!(quad([Vec3::X, Vec3::X * -3.0]), None);
        assert_eq!(quad([Vec3::X, Vec3::ZERO]), None);
        assert_eq!(quad([Vec3::X, Vec3::NAN]), None);
        assert!(quad([Vec3::X * 1e-25, Vec3::Y * 1e-30]).is_some());
    }

    /// The plane that is asked is the one with the rounded normal, and thin quads are the ones whose
    /// edges are not in it.
    #[test]
    fn the_error_covers_the_point() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(28, trial);
            let mut decade = |low, high| common::math::pow(10.0, stream.between(low, high));
            let (near, size, thin) = (decade(-4.0, 6.0), decade(-4.0, 4.0), decade(-3.0, 0.0));
            let mut vector = || {
                let mut component = || stream.between(-1.0, 1.0);
                Vec3::new(component(), component(), component())
            };
            let (corner, edge) = (near * vector(), size * vector());
            let second = edge + thin * size * vector();
            let Some(quad) = Quad::new(corner, [edge, second]) else { continue };
            let target = corner + 0.3 * edge + 0.5 * second;
            let origin = target + size * vector();
            let ray = Ray { origin, direction: target - origin };
            let Some(hit) = quad.hit(&ray, f32::INFINITY) else { continue };
            let normal = hit.geometric.as_dvec3();
            let height = (hit.point.as_dvec3() - corner.as_dvec3()).dot(normal).abs();
            let bound = normal.abs().dot(hit.error.as_dvec3());
            assert!(height <= bound, "{trial}: {height} {bound}");
        }
    }
}
