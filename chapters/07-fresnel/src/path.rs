//! A ray on its way through glass, and the choices that a reader has.

use common::sampler::Purpose;
use glam::DVec3;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;
use shadows::spawn::spawn;

use crate::inside::Inside;

/// Which formula says how much is reflected.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Formula {
    /// Fresnel's equations
    #[default]
    Exact,
    /// Schlick's approximation
    Schlick,
}

/// What becomes of light that is both reflected and refracted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Branching {
    /// Both rays are followed
    #[default]
    Both,
    /// One is, by chance: the more light it brings, the more often
    One,
}

// ANCHOR: path
/// A ray, and what its path has to remember.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    /// The ray that is asked of shapes.
    pub ray: Ray,
    /// Its direction with twice the digits.
    pub direction: DVec3,
    /// The bodies it is in.
    pub inside: Inside,
    /// How many surfaces it has left.
    pub bounce: u32,
}
// ANCHOR_END: path

impl Path {
    /// The path that goes on from `hit` in `direction`, on the surface's side that `side` points to.
    #[inline]
    pub(crate) fn at(&self, hit: &Hit, direction: DVec3, side: DVec3, inside: Inside) -> Self {
        let ray = Ray { origin: spawn(hit, side.as_vec3()), direction: direction.as_vec3() };
        Self { ray, direction, inside, bounce: self.bounce + 1 }
    }
}

/// What the random number is for that chooses one of two rays.
pub(crate) const WHICH_WAY: Purpose = Purpose::named("reflect or refract");
