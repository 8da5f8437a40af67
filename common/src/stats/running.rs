//! The mean and the variance of samples as they arrive.

/// A running mean and variance, in `f64`.
///
/// The textbook's `E[x²] - E[x]²` subtracts two numbers that are nearly equal as soon as the mean
/// is large against the spread (hard case MC-04). This keeps the squared deviations from the
/// current mean instead, and never subtracts large squares.
///
/// B. P. Welford, "Note on a method for calculating corrected sums of squares and products"
/// (Technometrics 4, 1962).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Running {
    count: u64,
    mean: f64,
    /// The sum of (x - mean)² over the samples so far.
    squares: f64,
}

impl Running {
    /// Takes in one sample.
    pub fn add(&mut self, sample: f64) {
        self.count += 1;
        let before = sample - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (sample - self.mean);
    }

    /// Takes in all samples another one has seen.
    ///
    /// Tony F. Chan, Gene H. Golub and Randall J. LeVeque, "Algorithms for computing the sample
    /// variance: analysis and recommendations" (The American Statistician 37, 1983).
    pub fn merge(&mut self, other: &Self) {
        if other.count == 0 {
            return;
        }
        let count = self.count + other.count;
        let share = other.count as f64 / count as f64;
        let apart = other.mean - self.mean;
        self.squares += other.squares + apart * apart * self.count as f64 * share;
        self.mean += apart * share;
        self.count = count;
    }

    /// How many samples there were.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Their mean; 0 when there were none.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The unbiased estimate of the variance of what they were drawn from (the sum of squares over
    /// count - 1); `None` for fewer than two samples.
    pub fn variance(&self) -> Option<f64> {
        (self.count > 1).then(|| self.squares / (self.count - 1) as f64)
    }

    /// The standard deviation of the mean itself; `None` for fewer than two samples.
    pub fn standard_error(&self) -> Option<f64> {
        self.variance().map(|variance| (variance / self.count as f64).sqrt())
    }
}

impl FromIterator<f64> for Running {
    fn from_iter<I: IntoIterator<Item = f64>>(samples: I) -> Self {
        let mut running = Self::default();
        for sample in samples {
            running.add(sample);
        }
        running
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg32;

    use super::Running;

    const SAMPLES: usize = 1_000_000;

    fn uniform(offset: f32) -> impl Iterator<Item = f32> {
        let mut random = Pcg32::seed_from_u64(7);
        (0..SAMPLES).map(move |_| offset + random.random::<f32>())
    }

    /// The negative control of MC-04: E[x²] - E[x]² in `f32`.
    fn naive_variance(samples: impl Iterator<Item = f32>) -> f32 {
        let (mut sum, mut squares) = (0.0f32, 0.0f32);
        for sample in samples {
            sum += sample;
            squares += sample * sample;
        }
        let mean = sum / SAMPLES as f32;
        squares / SAMPLES as f32 - mean * mean
    }

    /// Hard case MC-04: the variance of U(0, 1) is 1/12 wherever it is moved to.
    #[test]
    fn the_variance_does_not_see_the_offset() {
        for offset in [0.0, 1e2, 1e4] {
            let running: Running = uniform(offset).map(f64::from).collect();
            let variance = running.variance().unwrap();
            assert!((variance * 12.0 - 1.0).abs() < 0.01, "{variance} at offset {offset}");
        }
        let naive = naive_variance(uniform(1e4));
        assert!((naive * 12.0 - 1.0).abs() > 1e3, "the naive variance held: {naive}");
    }

    #[test]
    fn parts_merge_to_the_whole() {
        let all: Running = uniform(1e4).map(f64::from).collect();
        let mut merged = Running::default();
        let samples: Vec<f64> = uniform(1e4).map(f64::from).collect();
        for part in [&samples[..1], &samples[1..1], &samples[1..70_001], &samples[70_001..]] {
            merged.merge(&part.iter().copied().collect());
        }
        assert_eq!(merged.count(), all.count());
        assert!((merged.mean() - all.mean()).abs() < 1e-9);
        let ratio = merged.variance().unwrap() / all.variance().unwrap();
        assert!((ratio - 1.0).abs() < 1e-9, "{ratio}");
    }

    #[test]
    fn small_samples_by_hand() {
        let running: Running = [2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0].into_iter().collect();
        assert_eq!(running.mean(), 5.0);
        assert_eq!(running.variance(), Some(32.0 / 7.0));
        assert_eq!(running.standard_error(), Some((32.0_f64 / 56.0).sqrt()));
        assert_eq!([3.0].into_iter().collect::<Running>().variance(), None);
    }
}
