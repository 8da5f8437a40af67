//! The random numbers of one vertex of a path.

use common::sampler::{Purpose, Sampler};
use glam::Vec2;
use monte_carlo::sobol;

/// The direction in which a path goes on.
pub const DIRECTION: Purpose = Purpose::named("direction of scattering");
/// Which of several things a surface does with light.
pub const LOBE: Purpose = Purpose::named("lobe");

// ANCHOR: random
/// Random numbers, found by what they are for. Those for one purpose are spread evenly over the
/// samples of the pixel: sample number i takes point number i of a Sobol sequence.
#[derive(Clone, Copy, Debug)]
pub struct Random {
    sampler: Sampler,
    bounce: u32,
}

impl Random {
    /// The numbers at bounce `bounce`; 0 is the camera, 1 the first surface.
    #[inline]
    pub fn at(sampler: &Sampler, bounce: u32) -> Self {
        Self { sampler: *sampler, bounce }
    }

    /// Two numbers for one purpose, each in [0, 1).
    #[inline]
    pub fn pair(&self, purpose: Purpose) -> Vec2 {
        sobol::pair(self.sampler.index(), self.sampler.shared(self.bounce, purpose))
    }

    /// One number for one purpose, in [0, 1).
    #[inline]
    pub fn number(&self, purpose: Purpose) -> f32 {
        self.pair(purpose).x
    }
}
// ANCHOR_END: random

impl Random {
    /// The numbers of trial `trial` of an experiment that has no pixels.
    pub fn of_trial(seed: u64, trial: u64) -> Self {
        Self::at(&Sampler::new(seed, trial, 0, 1), 0)
    }
}
