//! A number or a vector for each triangle of a room.

use common::film::Color;
use glam::Vec3;
use triangles::bundle::{RAYS, Vectors};
use triangles::few::MOST;

/// A vector for each triangle, coordinate by coordinate. Its numbers are looked up without a question
/// whether they are there.
#[derive(Clone, Debug)]
pub(super) struct Column {
    x: [f32; MOST],
    y: [f32; MOST],
    z: [f32; MOST],
}

impl Column {
    pub(super) const ZERO: Self = Self { x: [0.0; MOST], y: [0.0; MOST], z: [0.0; MOST] };

    /// The vector of triangle number `place`; of another one if there is no such triangle.
    #[inline(always)]
    pub(super) fn at(&self, place: u32) -> Vec3 {
        let place = place as usize % MOST;
        Vec3::new(self.x[place], self.y[place], self.z[place])
    }

    /// The vectors of a triangle for each path.
    #[inline(always)]
    pub(super) fn of(&self, places: &[u32; RAYS]) -> Vectors {
        Vectors::of(|path| self.at(places[path]))
    }

    /// Changes the vector of triangle number `place`, which is below [`MOST`].
    pub(super) fn set(&mut self, place: usize, vector: Vec3) {
        (self.x[place], self.y[place], self.z[place]) = (vector.x, vector.y, vector.z);
    }
}

/// Whether there is any light.
#[inline(always)]
pub(super) fn is_some(light: Color) -> bool {
    (light.x != 0.0) | (light.y != 0.0) | (light.z != 0.0)
}
