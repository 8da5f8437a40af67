//! SH-01 and SH-02: triangles of every size at every distance, and a ray that leaves them.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use triangles::mesh::Mesh;

use super::draw;
use crate::offset::Leave;

/// A triangle that was hit, and a direction in which a ray leaves it.
pub(crate) struct Spot {
    mesh: Mesh,
    /// The hit.
    pub(crate) hit: Hit,
    direction: Vec3,
    /// The largest coordinate of the corners.
    size: f32,
    /// How large the triangle is.
    extent: f32,
}

impl Spot {
    /// A triangle 10⁻⁴ to 10⁴ large, 10⁻⁴ to 10⁶ from the origin. Where the lattice of `f32` leaves
    /// it no area there, another.
    pub(crate) fn new(trial: u64) -> Self {
        let mut stream = Stream::of_trial(501, trial);
        loop {
            let size = draw::decade(&mut stream, -4.0, 4.0);
            let distance = draw::decade(&mut stream, -4.0, 6.0);
            let made = Self::of_size(&mut stream, size, distance);
            if let Some(spot) = made {
                return spot;
            }
        }
    }

    fn of_size(stream: &mut Stream, size: f32, distance: f32) -> Option<Self> {
        let center = draw::direction(stream).as_vec3() * distance;
        let corners = [(); 3].map(|()| center + size * draw::in_cube(stream, 0.5));
        let weights = draw::weights(stream);
        let target = weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
        let away = size * draw::decade(stream, 0.0, 3.0);
        let origin = target + away * draw::direction(stream).as_vec3();
        let mesh = one(corners);
        let hit = mesh.hit(&Ray::new(origin, target - origin)?, f32::INFINITY)?;
        let direction = draw::leaving(stream, hit.geometric);
        let largest = corners.map(|corner| corner.abs().max_element());
        Some(Self {
            mesh,
            hit,
            direction,
            size: largest.into_iter().fold(0.0, f32::max),
            extent: size,
        })
    }

    /// Whether a ray that starts where `leave` says hits the triangle it leaves: a flat triangle
    /// is never hit by what leaves it.
    pub(crate) fn hits_itself(&self, leave: Leave) -> bool {
        let origin = leave(&self.hit, self.direction);
        self.mesh.is_hit(&Ray { origin, direction: self.direction }, f32::INFINITY)
    }

    /// Whether the ray misses a second triangle, parallel to the first and 64 floats before it.
    pub(crate) fn leaks(&self, leave: Leave) -> bool {
        let origin = leave(&self.hit, self.direction);
        !self.lid().is_hit(&Ray { origin, direction: self.direction }, f32::INFINITY)
    }

    pub(crate) fn bary_abs(&self) -> Vec3 {
        let w = Vec3::new(1.0 - self.hit.uv.x - self.hit.uv.y, self.hit.uv.x, self.hit.uv.y);
        triangles::surface::between([0, 1, 2].map(|i| self.mesh.positions[i].abs()), w)
    }

    /// A triangle before the first, around the place where the ray should meet it.
    fn lid(&self) -> Mesh {
        let normal = self.hit.geometric.as_dvec3();
        let direction = self.direction.as_dvec3();
        let gap = 64.0 * f64::from(draw::ulp(self.size));
        let along = gap / direction.dot(normal).abs();
        let middle = self.hit.point.as_dvec3() + along * direction;
        let (right, up) = normal.any_orthonormal_pair();
        let side = (0.5 * along).max(0.3 * f64::from(self.extent));
        let corner = |x: f64, y: f64| (middle + side * (x * right + y * up)).as_vec3();
        one([corner(0.0, 2.0), corner(-1.7, -1.0), corner(1.7, -1.0)])
    }
}

/// A mesh of one triangle.
fn one(corners: [Vec3; 3]) -> Mesh {
    Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]], ..Mesh::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::offset::Offset;

    #[test]
    fn counts() {
        for offset in Offset::ALL {
            let n = 200_000;
            let itself = (0..n).filter(|&t| Spot::new(t).hits_itself(offset.leave())).count();
            let leaks = (0..n).filter(|&t| Spot::new(t).leaks(offset.leave())).count();
            eprintln!("{} {itself} {leaks}", offset.name());
        }
        let n = 3_000_000;
        let f = |t: u64| {
            let mut stream = Stream::of_trial(506, t);
            let mut s = loop {
                let size = draw::decade(&mut stream, -4.0, 4.0);
                let corners = [
                    size * draw::decade(&mut stream, -8.0, -3.0) * draw::in_cube(&mut stream, 1.0),
                    size * draw::in_cube(&mut stream, 1.0),
                    size * draw::in_cube(&mut stream, 1.0),
                ];
                let near = draw::decade(&mut stream, -3.0, -0.5);
                let w = draw::weights(&mut stream) * near;
                let target = (1.0 - w.y - w.z) * corners[0] + w.y * corners[1] + w.z * corners[2];
                let origin = target + size * draw::direction(&mut stream).as_vec3();
                let mesh = one(corners);
                let Some(hit) =
                    mesh.hit(&Ray::new(origin, target - origin).unwrap(), f32::INFINITY)
                else {
                    continue;
                };
                let direction = draw::leaving(&mut stream, hit.geometric);
                break Spot { mesh, hit, direction, size, extent: size };
            };
            let full = s.hits_itself(crate::spawn::spawn);
            s.hit.error = ray_casting::rounding::gamma(4) * s.bary_abs();
            (full, s.hits_itself(crate::spawn::spawn))
        };
        let itself = (0..n).filter(|&t| f(t).1).count();
        let full = (0..n).filter(|&t| f(t).0).count();
        eprintln!("gamma full {full}");
        eprintln!("gamma7 alone {itself}");
    }
}
