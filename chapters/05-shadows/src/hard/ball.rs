//! SH-03: rays that leave spheres, outwards and inwards.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::double;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use ray_casting::sphere::Sphere;

use super::draw;
use crate::offset::Leave;

/// A sphere that was hit, and a direction in which a ray leaves it.
pub(crate) struct Spot {
    sphere: Sphere,
    hit: Hit,
    direction: Vec3,
}

impl Spot {
    pub(crate) fn new(trial: u64, lattice: f32) -> Self {
        let mut stream = Stream::of_trial(503, trial);
        loop {
            let radius = draw::decade(&mut stream, -4.0, 4.0);
            let center =
                draw::direction(&mut stream).as_vec3() * draw::decade(&mut stream, -4.0, 6.0);
            let sphere = Sphere { center, radius };
            if radius < lattice * draw::ulp(center.abs().max_element()) {
                continue;
            }
            if let Some(spot) = Self::on(&mut stream, sphere) {
                return spot;
            }
        }
    }

    fn on(stream: &mut Stream, sphere: Sphere) -> Option<Self> {
        let away = draw::direction(stream).as_vec3() * draw::decade(stream, -8.0, 8.0);
        let origin = if stream.bits().is_multiple_of(4) { sphere.center + away } else { away };
        let aim = sphere.center + sphere.radius * draw::in_cube(stream, 0.57);
        let hit = sphere.hit(&Ray::new(origin, aim - origin)?, f32::INFINITY)?;
        let direction = draw::leaving(stream, hit.geometric);
        Some(Self { sphere, hit, direction })
    }

    pub(crate) fn fails(&self, leave: Leave) -> u8 {
        let ray = Ray { origin: leave(&self.hit, self.direction), direction: self.direction };
        let found = self.sphere.hit(&ray, f32::INFINITY).map(|hit| f64::from(hit.t));
        if self.hit.geometric.dot(self.direction) > 0.0 {
            return u8::from(found.is_some());
        }
        let exact = double::crossing(&self.sphere, &ray, f64::from(self.sphere.radius));
        match found {
            None => 2,
            Some(t) if t < 0.5 * exact.leave => 3,
            Some(t) if t > 2.0 * exact.leave => 4,
            Some(_) if exact.enter > 0.0 || exact.leave < 0.0 => 5,
            _ => 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Spot;
    use crate::offset::Offset;

    #[test]
    fn counts() {
        for lattice in [0.0, 1.0, 4.0, 16.0, 64.0, 1024.0] {
            for offset in Offset::ALL {
                let mut n = [0; 6];
                for t in 0..300_000 {
                    n[usize::from(Spot::new(t, lattice).fails(offset.leave()))] += 1;
                }
                eprintln!("ball {lattice} {} {n:?}", offset.name());
            }
        }
        for part in [1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.12] {
            let mut n = [0; 6];
            for t in 0..1000_000 {
                let mut s = Spot::new(t, 4.0);
                s.hit.error *= part;
                n[usize::from(s.fails(crate::spawn::spawn))] += 1;
            }
            eprintln!("ball part {part} {n:?}");
        }
    }
}
