//! A family of densities on [0, 1], and one integral to try them on.

use common::math::pow;

use crate::estimator::Sample;

// ANCHOR: power
/// The density (k + 1) xᵏ on [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power {
    /// k, at least 0; 0 is uniform.
    pub exponent: f32,
}

impl Power {
    /// The place below which there is as much as 1 - u says: xᵏ⁺¹ = 1 - u. Never 0, as u is below 1.
    #[inline]
    pub fn place(&self, u: f32) -> f32 {
        pow(1.0 - u, 1.0 / (self.exponent + 1.0))
    }

    /// The density there.
    #[inline]
    pub fn density(&self, x: f32) -> f32 {
        (self.exponent + 1.0) * pow(x, self.exponent)
    }
}
// ANCHOR_END: power

/// The integral of x² over [0, 1].
pub const THIRD: f64 = 1.0 / 3.0;

impl Power {
    /// A sample of the integral of x².
    #[inline]
    pub fn sample(&self, u: f32) -> Sample {
        let x = self.place(u);
        Sample { value: f64::from(x * x), density: f64::from(self.density(x)) }
    }

    // ANCHOR: variance
    /// The variance of one estimate of the integral of x²: that of x⁴ / ((k + 1) xᵏ), less 1/9.
    /// `None` when it is infinite, from k = 5 on.
    pub fn variance(&self) -> Option<f64> {
        let k = f64::from(self.exponent);
        (k < 5.0).then(|| 1.0 / ((k + 1.0) * (5.0 - k)) - 1.0 / 9.0)
    }
    // ANCHOR_END: variance
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use common::stats::estimate::{Estimate, z_test};
    use common::stats::running::Running;

    use super::{Power, THIRD};

    fn samples(exponent: f32) -> Running {
        let power = Power { exponent };
        let number = |trial| Stream::of_trial(1102, trial).uniform();
        (0..200_000).map(|trial| power.sample(number(trial)).estimate()).collect()
    }

    /// k = 0: 1/5 - 1/9 = 4/45. k = 1: 1/8 - 1/9 = 1/72. k = 2: 0.
    #[test]
    fn variances_by_hand() {
        let of = |exponent| Power { exponent }.variance().expect("finite");
        assert!((of(0.0) - 4.0 / 45.0).abs() < 1e-15 && (of(1.0) - 1.0 / 72.0).abs() < 1e-15);
        assert!(of(2.0).abs() < 1e-15);
        assert_eq!(Power { exponent: 5.0 }.variance(), None);
    }

    #[test]
    fn means_and_variances_are_those_on_paper() {
        for exponent in [0.0, 1.0, 1.5, 3.0] {
            let found = samples(exponent);
            let estimate = Estimate::of(&found).expect("many samples");
            assert!(z_test(&estimate, &Estimate::exact(THIRD)).p_value > 1e-4, "{exponent}");
            let ratio =
                found.variance().expect("many") / Power { exponent }.variance().expect("so");
            assert!((ratio - 1.0).abs() < 0.05, "{exponent} {ratio}");
        }
        // Where the density has the integrand's shape, every sample is the answer.
        assert!(samples(2.0).variance().expect("many") < 1e-12);
    }
}
