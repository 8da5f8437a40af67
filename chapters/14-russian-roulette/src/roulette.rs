//! When a path ends: by chance, so that it is right on average.

use common::film::Color;
use common::sampler::Purpose;
use path_tracing::random::Random;
use path_tracing::strategy::Ending;

/// Whether a path goes on.
pub const SURVIVAL: Purpose = Purpose::named("survival of a path");

/// The least probability with which a path goes on: 2⁻¹².
///
/// Random numbers are multiples of 2⁻²⁴, so `chance < p` is true for ⌈p · 2²⁴⌉ of them. That is right
/// to one part in p · 2²⁴: here 4096. At p = 10⁻¹⁰ it would be 596 times too often (hard case PT-03).
pub const LEAST: f32 = 1.0 / 4096.0;

// ANCHOR: survive
/// What a path counts if it goes on with this `probability`, `None` if it ends. `chance` is uniform
/// in [0, 1).
///
/// James Arvo and David Kirk, "Particle transport and image synthesis" (SIGGRAPH 1990).
#[inline]
pub fn survive(probability: f32, chance: f32) -> Option<f32> {
    (chance < probability).then(|| 1.0 / probability)
}
// ANCHOR_END: survive

// ANCHOR: constant
/// All paths go on equally often: the report's equation 4-5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant {
    probability: f32,
}

impl Constant {
    /// The report's: 0.8.
    pub const REPORT: Self = Self { probability: 0.8 };

    /// Paths that go on with this `probability`. `None` if that is not from [`LEAST`] to 1.
    pub fn new(probability: f32) -> Option<Self> {
        (LEAST..=1.0).contains(&probability).then_some(Self { probability })
    }

    /// How often paths go on.
    pub fn probability(&self) -> f32 {
        self.probability
    }
}

impl Ending for Constant {
    #[inline]
    fn factor(&self, _throughput: Color, _bounce: u32, random: &Random) -> Option<f32> {
        survive(self.probability, random.number(SURVIVAL))
    }
}
// ANCHOR_END: constant

// ANCHOR: roulette
/// Paths that carry little go on seldom: each as often as the brightest colour of its throughput has
/// it, in units of `threshold`. One that carries the threshold or more always does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roulette {
    /// The throughput below which a path may end, at least 0. At 0 only black paths end.
    pub threshold: f32,
}

impl Roulette {
    /// The probability with which a path goes on: 0 if it carries nothing, or from [`LEAST`] to 1.
    #[inline]
    pub fn survival(&self, throughput: Color) -> f32 {
        let brightest = throughput.max_element();
        if brightest <= 0.0 {
            return 0.0;
        }
        // What is no number goes on, so that it is seen and counted where the path ends.
        if !(brightest < self.threshold) {
            return 1.0;
        }
        (brightest / self.threshold).max(LEAST)
    }
}

impl Ending for Roulette {
    #[inline]
    fn factor(&self, throughput: Color, _bounce: u32, random: &Random) -> Option<f32> {
        let probability = self.survival(throughput);
        if probability == 1.0 {
            return Some(1.0);
        }
        survive(probability, random.number(SURVIVAL))
    }
}
// ANCHOR_END: roulette

impl Default for Roulette {
    /// One half, for which `cost` has about the least error for the same time.
    fn default() -> Self {
        Self { threshold: 0.5 }
    }
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::stats::estimate::{Estimate, z_test};
    use common::stats::running::Running;
    use path_tracing::random::Random;
    use path_tracing::strategy::Ending;

    use super::{Constant, LEAST, Roulette, survive};

    #[test]
    fn by_hand() {
        // A fifth of the paths ends; the others count 1.25.
        assert_eq!(survive(0.8, 0.79), Some(1.25));
        assert_eq!(survive(0.8, 0.81), None);
        // Two walls of the box leave 0.5 of the light: 0.725 · 0.725.
        let survival = Roulette { threshold: 1.0 }.survival(Color::new(0.5, 0.3, 0.1));
        assert_eq!(survival, 0.5);
    }

    #[test]
    fn what_goes_on_carries_the_threshold() {
        let roulette = Roulette { threshold: 0.5 };
        for throughput in [Color::new(0.4, 0.1, 0.0), Color::new(0.01, 0.02, 0.03)] {
            let factor = 1.0 / roulette.survival(throughput);
            assert!(((throughput * factor).max_element() - 0.5).abs() < 1e-6);
        }
        assert_eq!(roulette.survival(Color::splat(0.5)), 1.0);
        assert_eq!(roulette.survival(Color::splat(1e-30)), LEAST);
        assert_eq!(roulette.survival(Color::ZERO), 0.0);
        assert_eq!(Roulette { threshold: 0.0 }.survival(Color::splat(1e-30)), 1.0);
    }

    #[test]
    fn black_paths_end_and_broken_ones_go_on() {
        let random = Random::of_trial(1, 0);
        let roulette = Roulette::default();
        assert_eq!(roulette.factor(Color::ZERO, 1, &random), None);
        assert_eq!(roulette.factor(Color::NAN, 1, &random), Some(1.0));
    }

    fn mean(ending: &impl Ending, throughput: Color) -> Estimate {
        let factor = |trial| ending.factor(throughput, 1, &Random::of_trial(14, trial));
        let samples: Running =
            (0..100_000).map(|trial| f64::from(factor(trial).unwrap_or(0.0))).collect();
        Estimate::of(&samples).expect("many samples")
    }

    #[test]
    fn every_ending_counts_one_on_average() {
        let gray = Color::new(0.02, 0.1, 0.05);
        let estimates = [
            mean(&Constant::REPORT, gray),
            mean(&Constant::new(0.05).expect("a probability"), gray),
            mean(&Roulette { threshold: 0.5 }, gray),
            mean(&Roulette { threshold: 2.0 }, gray),
        ];
        for estimate in estimates {
            assert!(z_test(&estimate, &Estimate::exact(1.0)).p_value > 0.001, "{estimate:?}");
        }
    }
}
