//! Rays: where light is followed, backwards, from the eye.

use glam::Vec3;

use crate::direction::unit;

// ANCHOR: ray
/// A half-line: the points `origin + t * direction` with `t` above 0.
///
/// The direction has length 1 when it comes from [`Ray::new`], so that `t` is a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes.
    pub direction: Vec3,
}
// ANCHOR_END: ray

impl Ray {
    /// The ray from `origin` along `direction`, whatever that one's length.
    ///
    /// None when the direction has no length or isn't finite, or the origin isn't finite.
    pub fn new(origin: Vec3, direction: Vec3) -> Option<Self> {
        let direction = unit(direction)?;
        origin.is_finite().then_some(Self { origin, direction })
    }

    // ANCHOR: at
    /// The point at distance `t` along the ray.
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.direction
    }
    // ANCHOR_END: at
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::Ray;

    #[test]
    fn a_point_on_the_ray_by_hand() {
        // (3, 0, -4) has length 5: ten along it is (6, 0, -8).
        let ray = Ray::new(Vec3::new(1.0, 2.0, 3.0), Vec3::new(3.0, 0.0, -4.0)).expect("finite");
        assert!((ray.at(10.0) - Vec3::new(7.0, 2.0, -5.0)).length() < 1e-6);
    }

    #[test]
    fn no_direction_no_ray() {
        assert_eq!(Ray::new(Vec3::ZERO, Vec3::ZERO), None);
        assert_eq!(Ray::new(Vec3::ZERO, Vec3::NAN), None);
        assert_eq!(Ray::new(Vec3::splat(f32::INFINITY), Vec3::X), None);
    }
}
