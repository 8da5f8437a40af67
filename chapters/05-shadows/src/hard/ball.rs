//! SH-03: rays that leave spheres, outwards and inwards.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::double;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use ray_casting::sphere::Sphere;

use super::draw;
use crate::naive;
use crate::offset::Leave;
use crate::spawn::spawn;

/// A sphere that was hit, and a direction in which a ray leaves it.
pub(crate) struct Spot {
    sphere: Sphere,
    hit: Hit,
    direction: Vec3,
}

impl Spot {
    /// A sphere with a radius of 10⁻⁴ to 10⁴, 10⁻⁴ to 10⁶ from the origin and hit from up to 10⁸
    /// away. Its radius is 64 steps of the lattice of `f32` or more: a step to the next `f32` must
    /// not lead out of it again.
    pub(crate) fn new(trial: u64) -> Self {
        let mut stream = Stream::of_trial(503, trial);
        loop {
            let radius = draw::decade(&mut stream, -4.0, 4.0);
            let distance = draw::decade(&mut stream, -4.0, 6.0);
            let center = draw::direction(&mut stream).as_vec3() * distance;
            let steps = f64::from(radius) / draw::ulp(center.abs().max_element());
            let spot = Self::on(&mut stream, Sphere { center, radius });
            if let Some(spot) = spot.filter(|_| steps >= 64.0) {
                return spot;
            }
        }
    }

    /// Seen from anywhere, from inside too.
    fn on(stream: &mut Stream, sphere: Sphere) -> Option<Self> {
        let away = draw::direction(stream).as_vec3() * draw::decade(stream, -8.0, 8.0);
        let near = stream.bits().is_multiple_of(4);
        let origin = if near { sphere.center + away } else { away };
        let aim = sphere.center + sphere.radius * draw::in_cube(stream, 0.57);
        let hit = sphere.hit(&Ray::new(origin, aim - origin)?, f32::INFINITY)?;
        let direction = draw::leaving(stream, hit.geometric);
        Some(Self { sphere, hit, direction })
    }

    /// Whether the sphere is hit from outside, or from inside elsewhere than where `f64` has it: a
    /// ray that leaves outwards hits nothing, and one inwards hits the far side.
    pub(crate) fn is_wrong(&self, leave: Leave) -> bool {
        let ray = Ray { origin: leave(&self.hit, self.direction), direction: self.direction };
        let found = self.sphere.hit(&ray, f32::INFINITY).map(|hit| f64::from(hit.t));
        if self.hit.geometric.dot(self.direction) > 0.0 {
            return found.is_some();
        }
        let exact = double::crossing(&self.sphere, &ray, f64::from(self.sphere.radius));
        let inside = exact.enter < 0.0 && 0.0 < exact.leave;
        !(inside && found.is_some_and(|t| (0.5..2.0).contains(&(t / exact.leave))))
    }
}

pub(super) fn naive(trial: u64) -> bool {
    Spot::new(trial).is_wrong(naive::fixed)
}

pub(super) fn robust(trial: u64) -> bool {
    Spot::new(trial).is_wrong(spawn)
}
