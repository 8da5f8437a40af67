//! A vertex of a path: where it met a surface, and how it left it.

use glam::Vec3;
use monte_carlo::frame::Frame;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;
use shadows::spawn::spawn;

use crate::bsdf::{Bsdf, BsdfSample};
use crate::space::Met;

// ANCHOR: vertex
/// A point of a surface where a path may turn.
#[derive(Clone, Copy, Debug)]
pub struct Vertex<'a, B> {
    /// Where it is.
    pub met: &'a Met,
    /// The surface's own axes: z is its outward normal.
    pub frame: Frame,
    /// Back along the path, towards the eye, in these axes.
    pub outgoing: Vec3,
    /// The surface's material.
    pub bsdf: &'a B,
}

impl<'a, B: Bsdf> Vertex<'a, B> {
    /// Where `ray` met a surface of material `bsdf`.
    #[inline]
    pub fn new(ray: &Ray, met: &'a Met, bsdf: &'a B) -> Self {
        let frame = Frame::around(met.hit.normal);
        let outgoing = frame.to_local(-ray.direction);
        Self { met, frame, outgoing, bsdf }
    }

    /// The hit.
    #[inline]
    pub fn hit(&self) -> &'a Hit {
        &self.met.hit
    }

    /// The ray along which the path goes on, and what later vertices have to know of it. `None` for a
    /// direction so low that rounding carried it through the surface (hard case PT-08).
    #[inline]
    pub fn leave(&self, sample: &BsdfSample) -> Option<(Ray, Departure)> {
        let ray = leaving(self.hit(), &self.frame, sample.incoming)?;
        let from = self.hit().point;
        Some((ray, Departure { from, pdf: sample.pdf, is_delta: sample.is_delta }))
    }
}

/// The ray that leaves `hit` in the direction `incoming` of its axes, if that is on the side it should be.
#[inline(always)]
pub fn leaving(hit: &Hit, frame: &Frame, incoming: Vec3) -> Option<Ray> {
    let direction = frame.to_world(incoming);
    let direction = direction / direction.length();
    let height = direction.dot(hit.geometric);
    (height * incoming.z > 0.0).then(|| Ray { origin: spawn(hit, direction), direction })
}
// ANCHOR_END: vertex

// ANCHOR: departure
/// How a path came to the vertex it is at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The vertex before, or the eye.
    pub from: Vec3,
    /// The density with which the direction was chosen, per steradian.
    pub pdf: f32,
    /// Whether there was no other direction: from a mirror, and from the eye.
    pub is_delta: bool,
}

impl Departure {
    /// Of the camera's ray.
    #[inline]
    pub fn from_eye(ray: &Ray) -> Self {
        Self { from: ray.origin, pdf: 1.0, is_delta: true }
    }
}
// ANCHOR_END: departure

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::{Vec2, Vec3};
    use ray_casting::ray::Ray;
    use ray_casting::shape::Hit;

    use super::{Departure, Vertex};
    use crate::bsdf::BsdfSample;
    use crate::lambert::Lambert;
    use crate::space::Met;

    fn met(normal: Vec3) -> Met {
        let point = Vec3::new(1.0, 2.0, 3.0);
        let error = Vec3::splat(1e-6);
        let hit = Hit { t: 2.0, point, error, geometric: normal, normal, uv: Vec2::ZERO };
        Met { hit, piece: 5, owner: 2 }
    }

    fn towards(incoming: Vec3) -> BsdfSample {
        BsdfSample { incoming, weight: Color::ONE, pdf: 0.25, is_delta: false }
    }

    #[test]
    fn the_outward_normal_is_z_whichever_side_the_ray_comes_from() {
        let met = met(Vec3::new(0.6, 0.8, 0.0));
        let bsdf = Lambert::new(0.5, 0.5, 0.5);
        for direction in [Vec3::NEG_Y, Vec3::Y] {
            let ray = Ray { origin: met.hit.point - 2.0 * direction, direction };
            let vertex = Vertex::new(&ray, &met, &bsdf);
            assert!((vertex.outgoing.z + 0.8 * direction.y).abs() < 1e-6);
            assert!((vertex.outgoing.length() - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn a_path_goes_on_from_the_side_it_leaves_on() {
        let met = met(Vec3::new(0.6, 0.8, 0.0));
        let bsdf = Lambert::new(0.5, 0.5, 0.5);
        let ray = Ray { origin: Vec3::new(1.0, 4.0, 3.0), direction: Vec3::NEG_Y };
        let vertex = Vertex::new(&ray, &met, &bsdf);
        for z in [0.8, -0.8] {
            let (onward, departure) = vertex.leave(&towards(Vec3::new(0.6, 0.0, z))).expect("up");
            let height = (onward.origin - met.hit.point).dot(met.hit.geometric);
            assert!(height * z > 0.0 && onward.direction.dot(met.hit.geometric) * z > 0.0);
            let expected = Departure { from: met.hit.point, pdf: 0.25, is_delta: false };
            assert_eq!(departure, expected);
        }
    }

    #[test]
    fn no_path_goes_along_the_surface_or_to_the_wrong_side() {
        let bsdf = Lambert::new(0.5, 0.5, 0.5);
        // The frame's normal, and the surface's own lean apart: as for a direction that was rounded.
        let mut met = met(Vec3::Z);
        met.hit.geometric = Vec3::new(0.28, 0.0, 0.96);
        let ray = Ray { origin: Vec3::new(1.0, 2.0, 5.0), direction: Vec3::NEG_Z };
        let vertex = Vertex::new(&ray, &met, &bsdf);
        assert!(vertex.leave(&towards(Vec3::new(-0.99, 0.0, 0.141))).is_none());
        assert!(vertex.leave(&towards(Vec3::X)).is_none());
        assert!(vertex.leave(&towards(Vec3::NAN)).is_none());
        assert!(vertex.leave(&towards(Vec3::Z)).is_some());
    }
}
