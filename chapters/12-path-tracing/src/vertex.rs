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
        let direction = self.frame.to_world(sample.incoming);
        let direction = direction / direction.length();
        let height = direction.dot(self.met.hit.geometric);
        if !(height * sample.incoming.z > 0.0) {
            return None;
        }
        let ray = Ray { origin: spawn(&self.met.hit, direction), direction };
        let from = self.met.hit.point;
        Some((ray, Departure { from, pdf: sample.pdf, is_delta: sample.is_delta }))
    }
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
