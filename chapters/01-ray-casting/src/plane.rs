//! The plane that has no edge.

use glam::{Vec2, Vec3};

use crate::direction::unit;
use crate::ray::Ray;
use crate::rounding::{Placed, gamma};
use crate::shape::{Hit, Shape};

/// An infinite plane, with a front: the side its normal points to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    point: Vec3,
    normal: Vec3,
}

impl Plane {
    /// The plane through `point` at right angles to `normal`, whatever that one's length.
    ///
    /// None when the normal has no length or isn't finite, or the point isn't finite.
    pub fn new(point: Vec3, normal: Vec3) -> Option<Self> {
        let normal = unit(normal)?;
        point.is_finite().then_some(Self { point, normal })
    }

    /// The direction the front faces, of length 1.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    // ANCHOR: distance
    /// Where along the ray the plane lies, if that is at `0 < t < t_max`.
    ///
    /// A ray in the plane, or beside it, divides by zero: the infinity or NaN that comes of it
    /// fails the comparisons, so that no "nearly parallel" has to be decided.
    pub fn distance(&self, ray: &Ray, t_max: f32) -> Option<f32> {
        let height = (self.point - ray.origin).dot(self.normal);
        let t = height / ray.direction.dot(self.normal);
        (0.0 < t && t < t_max).then_some(t)
    }
    // ANCHOR_END: distance

    // ANCHOR: foot
    /// The ray's point at `t`, moved along the normal onto the plane.
    ///
    /// Of its height before the move, the difference and the dot product leave four roundings of
    /// `beside`, and the normal's length and the product nine of `height`; the move rounds the
    /// point once. Asked again, the plane measures a height once more: four of `beside`.
    fn foot(&self, ray: &Ray, t: f32) -> Placed {
        let point = ray.at(t);
        let beside = point - self.point;
        let down = beside.dot(self.normal) * self.normal;
        let point = point - down;
        let error = gamma(9) * beside.abs() + gamma(14) * down.abs() + gamma(2) * point.abs();
        Placed { point, error }
    }
    // ANCHOR_END: foot
}

impl Shape for Plane {
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let t = self.distance(ray, t_max)?;
        let Placed { point, error } = self.foot(ray, t);

        // Squares of side 1, over and over.
        let (right, up) = self.normal.any_orthonormal_pair();
        let from_point = point - self.point;
        let place = Vec2::new(from_point.dot(right), from_point.dot(up));
        let (normal, uv) = (self.normal, place - place.floor());
        Some(Hit { t, point, error, geometric: normal, normal, uv })
    }

    fn hides_itself(&self, _eye: Vec3) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::{Vec2, Vec3};

    use super::Plane;
    use crate::ray::Ray;
    use crate::shape::Shape;

    #[test]
    fn a_hit_by_hand() {
        // Two below the origin, looking down 3 in 5: t = 2 / 0.6.
        let plane = Plane::new(Vec3::new(7.0, -2.0, 1.0), Vec3::Y * 3.0).expect("a plane");
        let ray = Ray { origin: Vec3::ZERO, direction: Vec3::new(0.0, -0.6, -0.8) };
        let hit = plane.hit(&ray, f32::INFINITY).expect("a hit");
        assert!((hit.t - 10.0 / 3.0).abs() < 1e-6);
        assert!((hit.point - Vec3::new(0.0, -2.0, -8.0 / 3.0)).length() < 1e-6);
        assert_eq!(hit.normal, Vec3::Y);
        assert!(hit.uv.cmpge(Vec2::ZERO).all() && hit.uv.cmple(Vec2::ONE).all());
        assert!(plane.hit(&ray, hit.t).is_none(), "0 < t < t_max");
    }

    #[test]
    fn beside_in_and_behind_are_misses() {
        let plane = Plane::new(Vec3::ZERO, Vec3::Y).expect("a plane");
        let miss = |origin, direction| plane.distance(&Ray { origin, direction }, f32::INFINITY);
        assert_eq!(miss(Vec3::Y, Vec3::X), None, "beside");
        assert_eq!(miss(Vec3::ZERO, Vec3::X), None, "in the plane");
        assert_eq!(miss(Vec3::Y, Vec3::Y), None, "behind");
        assert_eq!(miss(Vec3::Y, Vec3::ZERO), None, "no direction");
        assert_eq!(miss(Vec3::NAN, Vec3::NEG_Y), None, "no origin");
        assert_eq!(miss(Vec3::Y, Vec3::NEG_Y * 1e-9), Some(1e9), "a very short direction");
    }

    #[test]
    fn a_plane_needs_a_normal_and_a_place() {
        assert_eq!(Plane::new(Vec3::ZERO, Vec3::ZERO), None);
        assert_eq!(Plane::new(Vec3::NAN, Vec3::Y), None);
    }

    #[test]
    fn the_error_covers_the_point() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(27, trial);
            let mut decade = |low, high| common::math::pow(10.0, stream.between(low, high));
            let (near, far) = (decade(-4.0, 6.0), decade(-6.0, 8.0));
            let mut vector = || {
                let mut component = || stream.between(-1.0, 1.0);
                Vec3::new(component(), component(), component())
            };
            let Some(plane) = Plane::new(near * vector(), vector()) else { continue };
            let ray = Ray { origin: far * vector(), direction: vector() };
            let Some(hit) = plane.hit(&ray, f32::INFINITY) else { continue };
            let normal = plane.normal.as_dvec3();
            let height = (hit.point.as_dvec3() - plane.point.as_dvec3()).dot(normal).abs();
            let bound = normal.abs().dot(hit.error.as_dvec3());
            assert!(height <= bound, "{trial}: {height} {bound}");
        }
    }
}
