//! Do samples follow the density they claim to?

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// The fewest samples a bin must expect: below that its count is too far from normal.
const ENOUGH: f64 = 5.0;

/// How much the expected and the observed totals may differ, relative to the observed.
const TOTALS: f64 = 1e-3;

/// What a goodness-of-fit test found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The sum of (observed - expected)² / expected; infinite when a sample fell where none can.
    pub statistic: f64,
    /// Degrees of freedom: bins after pooling, less one.
    pub freedom: u64,
    /// How often a right sampler would fit at least as badly.
    pub p_value: f64,
}

/// Why two histograms can't be compared.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Unfit {
    /// One has more bins than the other.
    #[error("{observed} observed bins, but {expected} expected ones")]
    Bins {
        /// Bins observed.
        observed: usize,
        /// Bins expected.
        expected: usize,
    },
    /// The expected counts don't add up to the number of samples: a density that doesn't
    /// integrate to 1.
    #[error("{observed} samples, but the expected counts add up to {expected}")]
    Totals {
        /// Samples observed.
        observed: u64,
        /// The sum of the expected counts.
        expected: f64,
    },
    /// An expected count is negative, infinite or NaN.
    #[error("bin {bin} expects {count} samples")]
    Count {
        /// The bin, from 0.
        bin: usize,
        /// Its expected count.
        count: f64,
    },
    /// Fewer than two bins are left after those that expect under five samples were pooled.
    #[error("too few samples: fewer than two bins expect five or more")]
    TooFew,
}

/// Pearson's χ² test of a histogram against the counts its density expects.
///
/// Bins that expect fewer than five samples are pooled into one. Neither histogram needs an order.
///
/// Karl Pearson, "On the criterion that a given system of deviations ... can be reasonably supposed
/// to have arisen from random sampling" (Philosophical Magazine 50, 1900).
pub fn goodness_of_fit(observed: &[u64], expected: &[f64]) -> Result<Fit, Unfit> {
    check(observed, expected)?;
    let bins = pool(observed, expected);
    if bins.len() < 2 {
        return Err(Unfit::TooFew);
    }
    let freedom = bins.len() as u64 - 1;
    let statistic = if falls_where_none_can(observed, expected) {
        f64::INFINITY
    } else {
        bins.iter().map(Bin::term).sum()
    };
    let distribution = ChiSquared::new(freedom as f64).map_err(|_| Unfit::TooFew)?;
    Ok(Fit { statistic, freedom, p_value: distribution.sf(statistic) })
}

struct Bin {
    observed: f64,
    expected: f64,
}

impl Bin {
    fn term(&self) -> f64 {
        let difference = self.observed - self.expected;
        difference * difference / self.expected
    }

    fn join(&mut self, other: &Self) {
        self.observed += other.observed;
        self.expected += other.expected;
    }
}

fn check(observed: &[u64], expected: &[f64]) -> Result<(), Unfit> {
    if observed.len() != expected.len() {
        return Err(Unfit::Bins { observed: observed.len(), expected: expected.len() });
    }
    let bad = expected.iter().position(|count| !(count.is_finite() && *count >= 0.0));
    if let Some(bin) = bad {
        return Err(Unfit::Count { bin, count: expected[bin] });
    }
    let (samples, total) = (observed.iter().sum::<u64>(), expected.iter().sum::<f64>());
    if (total - samples as f64).abs() > TOTALS * samples as f64 {
        return Err(Unfit::Totals { observed: samples, expected: total });
    }
    Ok(())
}

fn falls_where_none_can(observed: &[u64], expected: &[f64]) -> bool {
    observed.iter().zip(expected).any(|(&observed, &expected)| observed > 0 && expected == 0.0)
}

/// The bins that expect enough, and one of all the others together.
fn pool(observed: &[u64], expected: &[f64]) -> Vec<Bin> {
    let bins = observed
        .iter()
        .zip(expected)
        .map(|(&observed, &expected)| Bin { observed: observed as f64, expected });
    let (mut large, small): (Vec<Bin>, Vec<Bin>) = bins.partition(|bin| bin.expected >= ENOUGH);

    // What is pooled may still expect too few; then the smallest of the large bins takes it in.
    let mut rest = Bin { observed: 0.0, expected: 0.0 };
    small.iter().for_each(|bin| rest.join(bin));
    let smallest = large.iter_mut().min_by(|a, b| a.expected.total_cmp(&b.expected));
    match smallest {
        Some(smallest) if rest.expected < ENOUGH => smallest.join(&rest),
        _ if rest.expected >= ENOUGH => large.push(rest),
        _ => {}
    }
    large
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg32;

    use super::{Unfit, goodness_of_fit};

    /// Two degrees of freedom: p = exp(-x / 2). Table: 5.991 at 5 %.
    #[test]
    fn two_degrees_of_freedom_have_a_closed_form() {
        let fit = goodness_of_fit(&[30, 14, 16], &[20.0, 20.0, 20.0]).unwrap();
        assert_eq!((fit.statistic, fit.freedom), ((100.0 + 36.0 + 16.0) / 20.0, 2));
        assert!((fit.p_value - libm::exp(-fit.statistic / 2.0)).abs() < 1e-14, "{fit:?}");
    }

    /// W. F. R. Weldon's 26,306 throws of twelve dice, on which Pearson's paper tried the test: how
    /// often 0 to 12 of them showed a five or a six, against a fair chance of 1/3.
    #[test]
    fn weldons_dice_are_not_fair() {
        let observed = [185, 1149, 3265, 5475, 6114, 5194, 3067, 1331, 403, 105, 14, 4, 0];
        let throws = 26_306.0;
        let mut chance = libm::pow(2.0 / 3.0, 12.0);
        let expected: Vec<f64> = (0..13)
            .map(|k| {
                let count = throws * chance;
                chance *= f64::from(12 - k) / f64::from(k + 1) * 0.5;
                count
            })
            .collect();
        let fit = goodness_of_fit(&observed, &expected).unwrap();
        assert_eq!(fit.freedom, 10, "eleven and twelve successes are pooled into ten");
        assert!((fit.statistic - 35.49).abs() < 0.005, "{fit:?}");

        // For an even number of degrees, p = exp(-h) (1 + h + ... + h^4 / 4!), h half the statistic.
        let h = fit.statistic / 2.0;
        let series = 1.0 + h * (1.0 + h / 2.0 * (1.0 + h / 3.0 * (1.0 + h / 4.0)));
        assert!((fit.p_value / (libm::exp(-h) * series) - 1.0).abs() < 1e-12, "{fit:?}");
        assert!(fit.p_value < 2e-4);
    }

    /// A histogram of `samples` numbers with density 1 + tilt (x - 1/2), on 20 bins of [0, 1].
    fn histogram(samples: u32, tilt: f64) -> Vec<u64> {
        let mut random = Pcg32::seed_from_u64(11);
        let mut counts = vec![0; 20];
        for _ in 0..samples {
            let x: f64 = random.random();
            let keep = random.random::<f64>() < 0.5 + tilt / 2.0 * (x - 0.5);
            let x = if keep { x } else { 1.0 - x };
            counts[((x * 20.0) as usize).min(19)] += 1;
        }
        counts
    }

    /// Hard case MC-08: the test must have the power to find a density that is a little wrong. An
    /// error of e at both ends moves the statistic by samples * e² / 3, and chance by about six.
    #[test]
    fn a_planted_error_of_one_and_five_percent_is_rejected() {
        let p_value = |samples: u32, tilt: f64| {
            let expected = vec![f64::from(samples) / 20.0; 20];
            goodness_of_fit(&histogram(samples, tilt), &expected).unwrap().p_value
        };
        assert!(p_value(4_000_000, 0.0) > 0.01, "a uniform generator is uniform");
        assert!(p_value(4_000_000, 0.02) < 1e-9, "1 % too many at one end, too few at the other");
        assert!(p_value(200_000, 0.1) < 1e-9, "5 %");
    }

    #[test]
    fn small_bins_are_pooled() {
        let fit = goodness_of_fit(&[50, 40, 4, 3, 3], &[45.0, 45.0, 4.0, 3.0, 3.0]).unwrap();
        assert_eq!(fit.freedom, 2);
        assert!((fit.statistic - 50.0 / 45.0).abs() < 1e-12);
        // Four expected in all are too few for a bin of their own: the smallest takes them.
        let fit = goodness_of_fit(&[40, 55, 2, 3], &[40.0, 56.0, 2.0, 2.0]).unwrap();
        assert_eq!(fit.freedom, 1);
    }

    #[test]
    fn a_sample_where_none_can_fall_is_impossible() {
        let fit = goodness_of_fit(&[50, 49, 1], &[50.0, 50.0, 0.0]).unwrap();
        assert_eq!((fit.statistic, fit.p_value), (f64::INFINITY, 0.0));
    }

    #[test]
    fn what_cannot_be_compared_says_why() {
        let bins = goodness_of_fit(&[10, 10], &[20.0]);
        assert_eq!(bins, Err(Unfit::Bins { observed: 2, expected: 1 }));
        let totals = goodness_of_fit(&[10, 10], &[10.0, 11.0]);
        assert_eq!(totals, Err(Unfit::Totals { observed: 20, expected: 21.0 }));
        assert!(matches!(
            goodness_of_fit(&[10, 10], &[20.0, f64::NAN]),
            Err(Unfit::Count { bin: 1, .. })
        ));
        assert_eq!(goodness_of_fit(&[4, 4], &[4.0, 4.0]), Err(Unfit::TooFew));
        assert_eq!(goodness_of_fit(&[], &[]), Err(Unfit::TooFew));
    }
}
