//! An integral as a mean.

use common::stats::running::Running;

// ANCHOR: sample
/// What one sample found: the integrand's value at a random place, and how dense such places are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// f(x), in the integrand's unit.
    pub value: f64,
    /// p(x), per unit of what is integrated over: length, area, steradian.
    pub density: f64,
}

impl Sample {
    /// f(x) / p(x): an estimate of the integral by this sample alone. 0 where there is nothing.
    #[inline]
    pub fn estimate(&self) -> f64 {
        if self.value == 0.0 { 0.0 } else { self.value / self.density }
    }
}
// ANCHOR_END: sample

// ANCHOR: mean
/// The mean of the estimates of `count` samples, and their variance.
///
/// Equation 4-2 of the report. Its expected value is the integral if the density is above 0
/// wherever the integrand isn't 0, and is the one that the samples really have.
pub fn mean(count: u32, sample: impl Fn(u32) -> Sample) -> Running {
    (0..count).map(|index| sample(index).estimate()).collect()
}
// ANCHOR_END: mean

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use common::stats::estimate::{Estimate, z_test};

    use super::{Sample, mean};

    /// Three throws at x² on [0, 1]: 0.2, 0.5 and 0.9 give (0.04 + 0.25 + 0.81) / 3.
    #[test]
    fn three_samples_by_hand() {
        let places = [0.2, 0.5, 0.9];
        let sample = |index| {
            let x: f64 = places[index as usize];
            Sample { value: x * x, density: 1.0 }
        };
        assert!((mean(3, sample).mean() - 1.1 / 3.0).abs() < 1e-15);
    }

    #[test]
    fn a_density_on_a_longer_interval() {
        // x² over [0, 2] is 8/3; uniform places there have the density 1/2.
        let found = mean(100_000, |index| {
            let x = 2.0 * f64::from(Stream::of_trial(1100, u64::from(index)).uniform());
            Sample { value: x * x, density: 0.5 }
        });
        let found = Estimate::of(&found).expect("many samples");
        assert!(z_test(&found, &Estimate::exact(8.0 / 3.0)).p_value > 1e-4, "{found:?}");
    }

    /// 0.34 with a standard error of 0.002, where 1/3 is right, is 3.3 of them off: once in 1150.
    #[test]
    fn a_test_by_hand() {
        let found = Estimate { mean: 0.34, standard_error: 0.002 };
        let test = z_test(&found, &Estimate::exact(1.0 / 3.0));
        assert!((test.statistic - 10.0 / 3.0).abs() < 1e-9);
        assert!((1.0 / test.p_value - 1165.0).abs() < 15.0, "{test:?}");
    }

    #[test]
    fn nothing_over_nothing_is_nothing() {
        assert_eq!(Sample { value: 0.0, density: 0.0 }.estimate(), 0.0);
        assert_eq!(Sample { value: 3.0, density: 0.5 }.estimate(), 6.0);
    }
}
