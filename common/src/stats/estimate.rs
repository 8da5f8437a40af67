//! Is this mean the right one, but for noise?
//!
//! Every test here is two-sided: it asks how often correct code would be off by at least as much,
//! in either direction. A p-value below the significance you chose beforehand is a rejection.

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use super::running::Running;

/// A mean, and how far chance moves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The mean itself.
    pub mean: f64,
    /// Its standard deviation: 0 when it is exact, as from a closed form.
    pub standard_error: f64,
}

impl Estimate {
    /// A value without noise.
    pub fn exact(mean: f64) -> Self {
        Self { mean, standard_error: 0.0 }
    }

    /// The mean of samples; `None` for fewer than two.
    pub fn of(samples: &Running) -> Option<Self> {
        let standard_error = samples.standard_error()?;
        Some(Self { mean: samples.mean(), standard_error })
    }

    /// Whether both can be the same number: the z-test doesn't reject at `significance`. Two that
    /// are the same agree, even when they are infinite or NaN.
    pub fn agrees(&self, other: &Self, significance: f64) -> bool {
        let same = |a: f64, b: f64| a == b || a.is_nan() && b.is_nan();
        same(self.mean, other.mean) && same(self.standard_error, other.standard_error)
            || z_test(self, other).p_value >= significance
    }
}

/// What a test found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// The deviation, in standard errors; its sign is that of the first mean minus the second.
    pub statistic: f64,
    /// How often correct code would be off by at least as much. NaN when an input was.
    pub p_value: f64,
}

/// The z-test of two means whose errors are normal: for many samples (100 and more).
pub fn z_test(first: &Estimate, second: &Estimate) -> Test {
    let (u, v) = (first.standard_error, second.standard_error);
    let error = (u * u + v * v).sqrt();
    let statistic = deviation(first.mean - second.mean, error);
    Test { statistic, p_value: 2.0 * Normal::standard().sf(statistic.abs()) }
}

/// Student's t-test of the mean of `samples` against `expected`: right for few samples also, when
/// what they were drawn from is about normal. `None` for fewer than two samples.
///
/// "Student" (W. S. Gosset), "The probable error of a mean" (Biometrika 6, 1908).
pub fn t_test(samples: &Running, expected: f64) -> Option<Test> {
    let statistic = deviation(samples.mean() - expected, samples.standard_error()?);
    let freedom = (samples.count() - 1) as f64;
    Some(Test { statistic, p_value: two_sided(statistic, freedom)? })
}

/// Welch's t-test of two means, whose variances may differ. `None` when either has fewer than two
/// samples.
///
/// B. L. Welch, "The generalization of 'Student's' problem when several different population
/// variances are involved" (Biometrika 34, 1947).
pub fn welch_test(first: &Running, second: &Running) -> Option<Test> {
    let (first_error, second_error) = (first.standard_error()?, second.standard_error()?);
    let (u, v) = (first_error * first_error, second_error * second_error);
    let statistic = deviation(first.mean() - second.mean(), (u + v).sqrt());
    // The Welch-Satterthwaite degrees of freedom, from the share each mean has in the variance.
    let (m, n) = ((first.count() - 1) as f64, (second.count() - 1) as f64);
    let share = if u + v > 0.0 { u / (u + v) } else { 0.5 };
    let freedom = 1.0 / (share * share / m + (1.0 - share) * (1.0 - share) / n);
    Some(Test { statistic, p_value: two_sided(statistic, freedom)? })
}

/// How many errors `difference` is; nothing is 0 errors, also when the error is 0.
fn deviation(difference: f64, error: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference / error }
}

fn two_sided(statistic: f64, freedom: f64) -> Option<f64> {
    if statistic.is_nan() {
        return Some(f64::NAN);
    }
    let student = StudentsT::new(0.0, 1.0, freedom).ok()?;
    Some(2.0 * student.sf(statistic.abs()))
}

#[cfg(test)]
mod tests {
    use super::{Estimate, t_test, welch_test, z_test};
    use crate::stats::running::Running;

    fn running(samples: &[f64]) -> Running {
        samples.iter().copied().collect()
    }

    /// A printed table of the normal distribution: 1.959964 standard errors are 5 %.
    #[test]
    fn the_normal_table() {
        let zero = Estimate::exact(0.0);
        for (deviations, p_value) in
            [(1.0, 0.317_310_5), (1.959_964, 0.05), (2.575_829, 0.01), (3.290_527, 0.001)]
        {
            let estimate = Estimate { mean: -2.0 * deviations, standard_error: 2.0 };
            let test = z_test(&estimate, &zero);
            assert_eq!(test.statistic, -deviations);
            assert!((test.p_value / p_value - 1.0).abs() < 1e-5, "{test:?}");
        }
    }

    /// Two samples have one degree of freedom, where Student's distribution is Cauchy's:
    /// p = 1 - 2 atan(t) / pi. A table has t = 12.706 at 5 %.
    #[test]
    fn one_degree_of_freedom_is_cauchy() {
        let (mean, error) = (5.0, 1.0);
        let samples = running(&[mean - error, mean + error]);
        for t in [0.5, 1.0, 12.706_204_736] {
            let test = t_test(&samples, mean - t * error).unwrap();
            let closed = 1.0 - 2.0 * libm::atan(t) / std::f64::consts::PI;
            assert!((test.p_value / closed - 1.0).abs() < 1e-9, "{test:?} {closed}");
        }
    }

    /// Two degrees of freedom: p = 1 - t / sqrt(2 + t^2).
    #[test]
    fn two_degrees_of_freedom_have_a_closed_form() {
        let samples = running(&[1.0, 2.0, 6.0]);
        let t = 3.0 / samples.standard_error().unwrap();
        let test = t_test(&samples, 0.0).unwrap();
        assert!((test.p_value - (1.0 - t / (2.0 + t * t).sqrt())).abs() < 1e-12, "{test:?}");
    }

    #[test]
    fn a_million_samples_are_nearly_normal() {
        let samples: Running = (0..1_000_001).map(|i| f64::from(i % 2)).collect();
        for deviations in [0.3, 2.0, 5.0] {
            let expected = samples.mean() - deviations * samples.standard_error().unwrap();
            let student = t_test(&samples, expected).unwrap();
            let normal = z_test(&Estimate::of(&samples).unwrap(), &Estimate::exact(expected));
            assert!(
                (student.p_value / normal.p_value - 1.0).abs() < 1e-3,
                "{student:?} {normal:?}"
            );
        }
    }

    /// Equal counts and variances: Welch's test is Student's with the degrees added.
    #[test]
    fn welch_of_two_alike_is_student() {
        let test = welch_test(&running(&[1.0, 2.0, 3.0]), &running(&[2.0, 3.0, 4.0])).unwrap();
        // t = -1 / sqrt(2/3), freedom 4; closed form for 4: I = 1 - s (3 - s^2) / 2, s = sin(angle).
        let t: f64 = 1.0 / (2.0_f64 / 3.0).sqrt();
        let s = t / (4.0 + t * t).sqrt();
        assert!((test.statistic + t).abs() < 1e-12);
        assert!((test.p_value - (1.0 - s * (3.0 - s * s) / 2.0)).abs() < 1e-12, "{test:?}");
    }

    #[test]
    fn without_spread_only_the_same_number_passes() {
        let constant = running(&[2.5; 4]);
        assert_eq!(t_test(&constant, 2.5).unwrap().p_value, 1.0);
        assert_eq!(t_test(&constant, 2.6).unwrap().p_value, 0.0);
        assert_eq!(welch_test(&constant, &constant).unwrap().p_value, 1.0);
        assert_eq!(t_test(&running(&[1.0]), 1.0), None);
    }

    #[test]
    fn estimates_agree_within_noise_only() {
        let estimate = Estimate { mean: 1.02, standard_error: 0.01 };
        assert!(estimate.agrees(&Estimate::exact(1.0), 0.01));
        assert!(!estimate.agrees(&Estimate::exact(1.1), 0.01));
        let broken = Estimate::exact(f64::NAN);
        assert!(!broken.agrees(&estimate, 0.01));
        assert!(broken.agrees(&broken, 0.01), "a mistake that gives NaN is recognised by it");
        let other = Estimate { mean: -f64::NAN, standard_error: f64::NAN };
        let same = Estimate { mean: f64::NAN, standard_error: f64::NAN };
        assert!(other.agrees(&same, 0.01), "whatever the bits of the NaN");
    }
}
