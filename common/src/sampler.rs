//! Random numbers, each found by what it is for and not by what was drawn before it.
//!
//! A number is keyed by (seed, pixel, sample, bounce, purpose). So a picture doesn't depend on the
//! order in which pixels are drawn, and leaving out one effect never shifts the numbers of another.
//!
//! The generator is PCG-XSH-RR 64/32 (O'Neill, "PCG: A family of simple fast space-efficient
//! statistically good algorithms for random number generation", 2014). The key becomes its state
//! and stream by the finalizer of SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom
//! number generators", 2014).

use glam::Vec2;
use rand::Rng;
use rand_pcg::Pcg32;

/// What a random number decides, such as "position in the pixel".
///
/// Two purposes with different names have different numbers, wherever they are declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Purpose(u64);

impl Purpose {
    /// The purpose with this name (its FNV-1a hash is the key).
    pub const fn named(name: &str) -> Self {
        let bytes = name.as_bytes();
        let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
        let mut index = 0;
        while index < bytes.len() {
            hash = (hash ^ bytes[index] as u64).wrapping_mul(0x0000_0100_0000_01b3);
            index += 1;
        }
        Self(hash)
    }
}

/// Where in the pixel a sample lies.
pub const PIXEL_OFFSET: Purpose = Purpose::named("pixel offset");

/// The random numbers of one sample of one pixel.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    /// The same for all samples of the pixel.
    pixel: u64,
    key: u64,
    index: u32,
    count: u32,
}

impl Sampler {
    /// The numbers of sample `index` of `count` in pixel number `pixel`.
    #[inline(always)]
    pub fn new(seed: u64, pixel: u64, index: u32, count: u32) -> Self {
        let pixel = mix(mix(seed) ^ pixel);
        Self { pixel, key: mix(pixel ^ u64::from(index)), index, count }
    }

    /// Which of the pixel's samples this is, from 0.
    #[inline]
    pub fn index(&self) -> u32 {
        self.index
    }

    /// How many samples the pixel has.
    #[inline]
    pub fn count(&self) -> u32 {
        self.count
    }

    /// The numbers for one purpose at one bounce of the path (0 is the camera).
    #[inline]
    pub fn stream(&self, bounce: u32, purpose: Purpose) -> Stream {
        let state = mix(self.key ^ purpose.0);
        Stream(Pcg32::new(mix(state ^ u64::from(bounce)), state))
    }

    /// 64 random bits that all samples of the pixel share, for one purpose at one bounce: where
    /// numbered points begin of which each sample takes one.
    #[inline(always)]
    pub fn shared(&self, bounce: u32, purpose: Purpose) -> u64 {
        // Multiples of an odd number differ for all bounces there are.
        let step = u64::from(bounce).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        mix(self.pixel ^ purpose.0.wrapping_add(step))
    }

    /// Where in its pixel the sample lies, each coordinate in [0, 1): the centre when the pixel has
    /// one sample, anywhere when it has more.
    #[inline]
    pub fn pixel_offset(&self) -> Vec2 {
        if self.count == 1 { Vec2::splat(0.5) } else { self.stream(0, PIXEL_OFFSET).uniform2() }
    }
}

/// Several samplers side by side, for loops over all of them.
#[derive(Clone, Copy, Debug)]
pub struct Samplers<const COUNT: usize> {
    pixel: [u64; COUNT],
    key: [u64; COUNT],
    index: [u32; COUNT],
    count: [u32; COUNT],
}

impl<const COUNT: usize> Samplers<COUNT> {
    /// All of them the same.
    #[inline(always)]
    pub fn splat(sampler: Sampler) -> Self {
        let Sampler { pixel, key, index, count } = sampler;
        let (pixel, key) = ([pixel; COUNT], [key; COUNT]);
        Self { pixel, key, index: [index; COUNT], count: [count; COUNT] }
    }

    /// Sampler number `place`.
    #[inline(always)]
    pub fn at(&self, place: usize) -> Sampler {
        let (pixel, key) = (self.pixel[place], self.key[place]);
        Sampler { pixel, key, index: self.index[place], count: self.count[place] }
    }

    /// Changes sampler number `place`.
    #[inline(always)]
    pub fn set(&mut self, place: usize, sampler: Sampler) {
        (self.pixel[place], self.key[place]) = (sampler.pixel, sampler.key);
        (self.index[place], self.count[place]) = (sampler.index, sampler.count);
    }
}

/// Uniform numbers in a fixed order.
#[derive(Clone, Debug)]
pub struct Stream(Pcg32);

impl Stream {
    /// The numbers of trial `trial` of an experiment that has no pixels.
    pub fn of_trial(seed: u64, trial: u64) -> Self {
        Sampler::new(seed, trial, 0, 1).stream(0, Purpose::named("trial"))
    }

    /// 32 random bits.
    #[inline]
    pub fn bits(&mut self) -> u32 {
        self.0.next_u32()
    }

    /// A uniform number in [0, 1), one of 2²⁴ evenly spaced. Dividing 32 bits by 2³² instead would
    /// round the top 128 of them to 1 (hard case MC-01).
    #[inline]
    pub fn uniform(&mut self) -> f32 {
        (self.bits() >> 8) as f32 * f32::EPSILON / 2.0
    }

    /// Two uniform numbers, drawn in the order x, y.
    #[inline]
    pub fn uniform2(&mut self) -> Vec2 {
        let x = self.uniform();
        let y = self.uniform();
        Vec2::new(x, y)
    }

    /// A uniform number in [`low`, `high`).
    #[inline]
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        let between = low + (high - low) * self.uniform();
        // Rounding can carry the sum up to the open end.
        if between < high { between } else { low }
    }
}

/// The finalizer of SplitMix64: every output bit depends on every input bit, and no two inputs
/// give the same output.
#[inline(always)]
fn mix(key: u64) -> u64 {
    let key = key.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let key = (key ^ (key >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let key = (key ^ (key >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    key ^ (key >> 31)
}

#[cfg(test)]
mod tests {
    use super::{PIXEL_OFFSET, Purpose, Sampler, Samplers, Stream, mix};

    #[test]
    fn splitmix64_gives_its_published_first_output() {
        assert_eq!(mix(0), 0xe220_a839_7b1d_cdaf);
    }

    #[test]
    fn samplers_side_by_side_are_what_each_was() {
        let sampler = |pixel: u64| Sampler::new(7, pixel, pixel as u32 % 3, 3);
        let mut samplers = Samplers::<4>::splat(sampler(9));
        (0..3).for_each(|place| samplers.set(place, sampler(place as u64)));
        for (place, pixel) in [0, 1, 2, 9].into_iter().enumerate() {
            let (found, expected) = (samplers.at(place), sampler(pixel));
            let numbers = |sampler: &Sampler| {
                let own = sampler.stream(1, PIXEL_OFFSET).bits();
                (own, sampler.shared(2, PIXEL_OFFSET), sampler.index(), sampler.count())
            };
            assert_eq!(numbers(&found), numbers(&expected));
        }
    }

    #[test]
    fn every_part_of_the_key_matters() {
        let lens = Purpose::named("lens");
        let first = |sampler: Sampler, bounce, purpose| sampler.stream(bounce, purpose).bits();
        let base = first(Sampler::new(1, 2, 3, 9), 4, lens);
        assert_ne!(base, first(Sampler::new(0, 2, 3, 9), 4, lens));
        assert_ne!(base, first(Sampler::new(1, 0, 3, 9), 4, lens));
        assert_ne!(base, first(Sampler::new(1, 2, 0, 9), 4, lens));
        assert_ne!(base, first(Sampler::new(1, 2, 3, 9), 0, lens));
        assert_ne!(base, first(Sampler::new(1, 2, 3, 9), 4, PIXEL_OFFSET));
        assert_eq!(base, first(Sampler::new(1, 2, 3, 9), 4, Purpose::named("lens")));
    }

    #[test]
    fn samples_of_one_pixel_share_what_is_for_all_of_them() {
        let lens = Purpose::named("lens");
        let shared = |pixel, index, bounce| Sampler::new(1, pixel, index, 9).shared(bounce, lens);
        assert_eq!(shared(2, 3, 4), shared(2, 5, 4));
        assert_ne!(shared(2, 3, 4), shared(1, 3, 4));
        assert_ne!(shared(2, 3, 4), shared(2, 3, 5));
        assert_ne!(shared(2, 3, 4), shared(2, 3, 68), "nor do they come round");
        assert_ne!(shared(2, 3, 4), Sampler::new(1, 2, 3, 9).shared(4, PIXEL_OFFSET));
    }

    #[test]
    fn the_largest_uniform_is_below_one() {
        assert!((u32::MAX >> 8) as f32 * f32::EPSILON / 2.0 < 1.0);
        assert_eq!(u32::MAX as f32 / 4_294_967_296.0, 1.0, "the naive form reaches 1");
    }

    #[test]
    fn neighbouring_trials_are_not_alike() {
        // The mean of n uniforms has standard deviation 1/sqrt(12 n): 5 of them is one in 10^6.
        let n = 1 << 20;
        let sum: f64 = (0..n).map(|trial| f64::from(Stream::of_trial(7, trial).uniform())).sum();
        let deviation = (sum / n as f64 - 0.5) * (12.0 * n as f64).sqrt();
        assert!(deviation.abs() < 5.0, "{deviation}");
    }
}
