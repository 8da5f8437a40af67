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
    #[inline(always)]
    pub fn at(sampler: &Sampler, bounce: u32) -> Self {
        Self { sampler: *sampler, bounce }
    }

    /// Two numbers for one purpose, each in [0, 1).
    #[inline(always)]
    pub fn pair(&self, purpose: Purpose) -> Vec2 {
        sobol::pair(self.sampler.index(), self.sampler.shared(self.bounce, purpose))
    }

    /// One number for one purpose, in [0, 1).
    #[inline(always)]
    pub fn number(&self, purpose: Purpose) -> f32 {
        sobol::first(self.sampler.index(), self.sampler.shared(self.bounce, purpose))
    }
}
// ANCHOR_END: random

impl Random {
    /// The numbers of trial `trial` of an experiment that has no pixels.
    pub fn of_trial(seed: u64, trial: u64) -> Self {
        Self::at(&Sampler::new(seed, trial, 0, 1), 0)
    }
}

#[cfg(test)]
mod tests {
    use common::sampler::Sampler;

    use super::{DIRECTION, LOBE, Random};

    #[test]
    fn a_number_depends_on_what_it_is_for_and_on_nothing_else() {
        let sampler = Sampler::new(1, 2, 3, 16);
        let random = Random::at(&sampler, 4);
        assert_eq!(random.pair(DIRECTION), Random::at(&sampler, 4).pair(DIRECTION));
        assert_ne!(random.pair(DIRECTION), random.pair(LOBE));
        assert_ne!(random.pair(DIRECTION), Random::at(&sampler, 5).pair(DIRECTION));
        let other = Sampler::new(1, 2, 4, 16);
        assert_ne!(random.pair(DIRECTION), Random::at(&other, 4).pair(DIRECTION));
    }

    #[test]
    fn a_pixel_s_samples_are_spread_evenly() {
        let mut seen = [0; 16];
        for index in 0..16 {
            let number = Random::at(&Sampler::new(1, 7, index, 16), 1).number(LOBE);
            seen[(16.0 * number) as usize] += 1;
        }
        assert_eq!(seen, [1; 16]);
    }

    #[test]
    fn trials_don_t_know_of_each_other() {
        // The mean of n uniforms has standard deviation 1/sqrt(12 n).
        let count = 1 << 16;
        let number = |trial| f64::from(Random::of_trial(129, trial).number(LOBE));
        let sum: f64 = (0..count).map(number).sum();
        let deviation = (sum / count as f64 - 0.5) * (12.0 * count as f64).sqrt();
        assert!(deviation.abs() < 5.0, "{deviation}");
    }
}
