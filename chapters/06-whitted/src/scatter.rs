//! The seam between rays that are followed and the scene they are followed through.

use common::film::Color;
use common::tally::{Event, Tally};

// ANCHOR: scatter
/// Something that rays can be followed through: it answers a ray with light, and with further rays
/// to ask for the rest of the light.
pub trait Scatter: Sync {
    /// What is followed: a ray, and whatever a path has to remember from one surface to the next.
    type Ray: Copy;

    /// What the ray meets, or that it meets nothing.
    fn scatter<T: Tally>(&self, ray: &Self::Ray, tally: &mut T) -> Scattered<Self::Ray>;
}

/// What comes back along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scattered<R> {
    /// The radiance that is known at once: of lamps, or of the background.
    pub light: Color,
    /// The rays that bring the rest.
    pub branches: [Option<Branch<R>>; 2],
}

/// A ray that brings a part of another one's light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch<R> {
    /// The ray.
    pub ray: R,
    /// How much of its radiance goes on, each part in [0, 1]. Those of two branches together are at
    /// most 1: no surface returns more than it gets.
    pub weight: Color,
    /// What is counted when it is followed.
    pub event: &'static Event,
}
// ANCHOR_END: scatter

impl<R> Scattered<R> {
    /// Light, and nothing else to follow.
    pub fn only(light: Color) -> Self {
        Self { light, branches: [None, None] }
    }

    /// Light, and perhaps one ray to follow.
    pub fn with(light: Color, branch: Option<Branch<R>>) -> Self {
        Self { light, branches: [branch, None] }
    }
}
