//! Measuring: how wrong a result is, and whether chance explains it.
//!
//! [`error`] says how far a picture or a list of numbers is from its reference. [`running`] keeps
//! a mean and a variance while samples arrive. [`estimate`] and [`chi_squared`] turn a deviation
//! into a probability: how often would correct code be at least this far off? [`sidak`] shares one
//! tolerated rate of false alarms among many such tests.

pub mod chi_squared;
pub mod error;
pub mod estimate;
pub mod running;

/// The significance each of `tests` tests may use, so that all of them together raise a false
/// alarm with probability `significance`: 1 - (1 - significance)^(1/tests).
///
/// Zbyněk Šidák, "Rectangular confidence regions for the means of multivariate normal
/// distributions" (Journal of the American Statistical Association 62, 1967).
///
/// `significance` is in (0, 1) and `tests` at least 1.
pub fn sidak(significance: f64, tests: u32) -> f64 {
    // Written with ln(1 + x) and exp(x) - 1, because 1 - significance loses a small significance.
    -libm::expm1(libm::log1p(-significance) / f64::from(tests))
}

#[cfg(test)]
mod tests {
    use super::sidak;

    #[test]
    fn ten_tests_share_five_percent() {
        // 1 - 0.95^(1/10) in decimal arithmetic of 40 digits.
        assert!((sidak(0.05, 10) - 0.005_116_196_891_823_7).abs() < 1e-15);
        assert_eq!(sidak(0.05, 1), 0.05);
    }

    #[test]
    fn a_tiny_significance_survives() {
        let naive = 1.0 - libm::pow(1.0 - 1e-17, 1.0 / 3.0);
        assert_eq!(naive, 0.0, "the formula as written has nothing left");
        assert!((sidak(1e-17, 3) - 1e-17 / 3.0).abs() < 1e-30);
    }
}
