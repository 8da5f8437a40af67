//! SH-01 and SH-02: triangles of every size at every distance, and rays that leave them.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use triangles::mesh::Mesh;

use super::draw;
use crate::naive;
use crate::offset::Leave;
use crate::spawn::spawn;

/// A triangle that was hit, and a direction in which a ray leaves it.
pub(crate) struct Spot {
    pub(super) mesh: Mesh,
    pub(super) hit: Hit,
    pub(super) direction: Vec3,
}

impl Spot {
    /// A triangle 10⁻⁴ to 10⁴ large, 10⁻⁴ to 10⁶ from the origin. Where the lattice of `f32` leaves
    /// it no area there, another.
    pub(crate) fn new(trial: u64) -> Self {
        let mut stream = Stream::of_trial(501, trial);
        loop {
            let size = draw::decade(&mut stream, -4.0, 4.0);
            let distance = draw::decade(&mut stream, -4.0, 6.0);
            let center = draw::direction(&mut stream).as_vec3() * distance;
            let corners = [(); 3].map(|()| center + size * draw::in_cube(&mut stream, 0.5));
            let weights = draw::weights(&mut stream);
            let away = size * draw::decade(&mut stream, 0.0, 3.0);
            if let Some(spot) = Self::seen(&mut stream, corners, weights, away) {
                return spot;
            }
        }
    }

    /// The triangle at the point with these weights, seen from `away`.
    pub(super) fn seen(
        stream: &mut Stream,
        corners: [Vec3; 3],
        weights: Vec3,
        away: f32,
    ) -> Option<Self> {
        let target = weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
        let origin = target + away * draw::direction(stream).as_vec3();
        let mesh = draw::triangle(corners);
        let hit = mesh.hit(&Ray::new(origin, target - origin)?, f32::INFINITY)?;
        let direction = draw::leaving(stream, hit.geometric);
        Some(Self { mesh, hit, direction })
    }

    /// The hit.
    #[cfg(feature = "native")]
    pub(crate) fn hit(&self) -> &Hit {
        &self.hit
    }

    /// Where the ray goes.
    #[cfg(feature = "native")]
    pub(crate) fn direction(&self) -> Vec3 {
        self.direction
    }

    /// The ray that starts where `leave` says.
    pub(crate) fn ray(&self, leave: Leave) -> Ray {
        Ray { origin: leave(&self.hit, self.direction), direction: self.direction }
    }

    /// Whether it hits the triangle it leaves, which a flat triangle never is.
    pub(crate) fn hits_itself(&self, leave: Leave) -> bool {
        self.mesh.is_hit(&self.ray(leave), f32::INFINITY)
    }

    /// Whether it misses a second triangle, parallel to the first and 64 floats before it.
    pub(crate) fn leaks(&self, leave: Leave) -> bool {
        !self.lid().is_hit(&self.ray(leave), f32::INFINITY)
    }

    /// A triangle before the first, as large and around the place where the ray should meet it. A
    /// float is the spacing at the largest coordinate of the first: what the lid's own corners are
    /// rounded to.
    fn lid(&self) -> Mesh {
        let [a, b, c] = self.mesh.corners(0);
        let largest = a.abs().max(b.abs()).max(c.abs()).max_element();
        let size = (a - b).length().max((a - c).length());
        let direction = self.direction.as_dvec3();
        let normal = self.hit.geometric.as_dvec3();
        let along = 64.0 * draw::ulp(largest) / direction.dot(normal).abs();
        let middle = self.hit.point.as_dvec3() + along * direction;
        let (right, up) = normal.any_orthonormal_pair();
        let side = along.max(f64::from(size)) / 2.0;
        let corner = |x: f64, y: f64| (middle + side * (x * right + y * up)).as_vec3();
        draw::triangle([corner(0.0, 1.0), corner(-0.9, -0.5), corner(0.9, -0.5)])
    }
}

pub(super) fn hits_itself_naive(trial: u64) -> bool {
    Spot::new(trial).hits_itself(naive::fixed)
}

pub(super) fn hits_itself_robust(trial: u64) -> bool {
    Spot::new(trial).hits_itself(spawn)
}

pub(super) fn leaks_naive(trial: u64) -> bool {
    Spot::new(trial).leaks(naive::normal)
}

pub(super) fn leaks_robust(trial: u64) -> bool {
    Spot::new(trial).leaks(spawn)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

    use common::sampler::Stream;
    use ray_casting::plane::Plane;
    use ray_casting::quad::Quad;
    use ray_casting::ray::Ray;
    use ray_casting::shape::Shape;

    use super::{Spot, draw, spawn};
    use crate::offset::Offset;

    /// The figures of the page, at ten million: self-hits and leaks of each cure.
    #[test]
    #[ignore = "takes a minute: cargo test --release -p shadows -- --ignored --nocapture"]
    fn ten_million_spawns_by_every_cure() {
        const SPAWNS: u64 = 10_000_000;
        for offset in Offset::ALL {
            let [hits, leaks] = [(); 2].map(|()| AtomicU64::new(0));
            std::thread::scope(|scope| {
                for start in 0..2 {
                    let (hits, leaks, leave) = (&hits, &leaks, offset.leave());
                    scope.spawn(move || {
                        for trial in (start..SPAWNS).step_by(2) {
                            let spot = Spot::new(trial);
                            hits.fetch_add(u64::from(spot.hits_itself(leave)), Relaxed);
                            leaks.fetch_add(u64::from(spot.leaks(leave)), Relaxed);
                        }
                    });
                }
            });
            let [hits, leaks] = [hits, leaks].map(AtomicU64::into_inner);
            println!("{}: {hits} self-hits, {leaks} leaks in {SPAWNS}", offset.name());
            assert_eq!(offset == Offset::Bound, hits + leaks == 0);
        }
    }

    /// The same for quads, thin ones among them, and for planes, which have no largest coordinate.
    #[test]
    fn nothing_flat_is_hit_by_what_leaves_it() {
        let mut spawns = 0;
        for trial in 0..300_000 {
            let mut stream = Stream::of_trial(511, trial);
            let size = draw::decade(&mut stream, -4.0, 4.0);
            let away = draw::decade(&mut stream, -4.0, 6.0);
            let center = draw::in_cube(&mut stream, away);
            let [right, up, aside] = [(); 3].map(|()| size * draw::in_cube(&mut stream, 1.0));
            let up = if trial.is_multiple_of(3) { right + 1e-3 * up } else { up };
            let flat: Option<Box<dyn Shape>> = match trial.is_multiple_of(2) {
                true => Quad::new(center, [right, up]).map(|quad| Box::new(quad) as _),
                false => Plane::new(center, up).map(|plane| Box::new(plane) as _),
            };
            let target = center + 0.3 * right + 0.4 * up;
            let ray = Ray { origin: target + aside, direction: -aside };
            let hit = flat.as_ref().and_then(|flat| flat.hit(&ray, f32::INFINITY));
            let (Some(flat), Some(hit)) = (flat, hit) else { continue };
            let direction = draw::leaving(&mut stream, hit.geometric);
            let ray = Ray { origin: spawn(&hit, direction), direction };
            assert_eq!(flat.hit(&ray, f32::INFINITY), None, "{trial}");
            spawns += 1;
        }
        assert!(spawns > 100_000, "{spawns}");
    }

    /// The bound is not much too large: a fifth of it is too small.
    #[test]
    fn a_fifth_of_the_bound_is_too_small() {
        let hits = (0..400_000).filter(|&trial| {
            let mut spot = Spot::new(trial);
            spot.hit.error /= 5.0;
            spot.hits_itself(spawn)
        });
        assert!(hits.count() > 0);
    }
}
