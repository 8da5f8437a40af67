//! Slab tests as they were published, and as they are often written. Each fails somewhere.
//!
//! All answer one question: does the ray meet the box at a `t` from 0 to `t_max`? Those that give
//! something else, or take their ray in another form, are written here for that question.

mod compared;
mod looped;
mod padded;

use glam::Vec3;
use ray_casting::ray::Ray;

use crate::aabb::Aabb;

pub use compared::{glam_vectors, natural, tavian_2015, tavian_2022};
pub use looped::{kay_kajiya, old_weekend, pbrt_fast, pbrt_loop, smits};
pub use padded::{folded, ize, safe_reciprocal, thickened};

// ANCHOR: plain
/// A ray with its reciprocals, and no care taken.
#[derive(Clone, Copy, Debug)]
pub struct PlainRay {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes.
    pub direction: Vec3,
    /// 1 over each component of the direction.
    pub inverse: Vec3,
}
// ANCHOR_END: plain

impl From<&Ray> for PlainRay {
    fn from(ray: &Ray) -> Self {
        let Ray { origin, direction } = *ray;
        Self { origin, direction, inverse: direction.recip() }
    }
}

/// A slab test: whether the ray meets the box between 0 and the last argument.
pub type Form = fn(&PlainRay, &Aabb, f32) -> bool;

// ANCHOR: union
/// The smallest box around some points, by glam's minimum: of a number and NaN it gives the second.
/// After a NaN, all that came before it is forgotten (hard cases X-01, BX-07).
pub fn of_points(points: &[Vec3]) -> Aabb {
    let empty = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let (min, max) =
        points.iter().fold(empty, |(min, max), &point| (min.min(point), max.max(point)));
    Aabb { min, max }
}
// ANCHOR_END: union
