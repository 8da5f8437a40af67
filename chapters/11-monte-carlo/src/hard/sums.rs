//! MC-04 and MC-05: means and variances of many numbers.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use common::stats::running::Running;

use super::CHAPTER;
use crate::naive;

/// How many samples a trial of MC-04 has.
const SAMPLES: usize = 32;

/// MC-04: the variance of numbers that are far from 0.
pub(super) const VARIANCE: Case = Case {
    id: "MC-04",
    chapter: CHAPTER,
    input: "the variance of 32 numbers from 100 to 10,001, to 1 %",
    most: UNLIMITED,
    naive_fails: |trial| {
        let samples = far_samples(trial);
        let unbiased = SAMPLES as f64 / (SAMPLES - 1) as f64;
        is_not_variance(&samples, unbiased * f64::from(naive::variance(&samples)))
    },
    robust_fails: |trial| {
        let samples = far_samples(trial);
        let running: Running = samples.iter().map(|&sample| f64::from(sample)).collect();
        is_not_variance(&samples, running.variance().unwrap_or(f64::NAN))
    },
};

fn far_samples(trial: u64) -> [f32; SAMPLES] {
    let mut stream = Stream::of_trial(1109, trial);
    let offset = [100.0, 1000.0, 10_000.0][trial as usize % 3];
    std::array::from_fn(|_| offset + stream.uniform())
}

/// The variance by integers: all samples are multiples of 2⁻¹⁷, and n Σx² - (Σx)² is exact.
fn is_not_variance(samples: &[f32], found: f64) -> bool {
    let unit = f64::from(1 << 17);
    let whole: Vec<i128> = samples.iter().map(|&it| (f64::from(it) * unit) as i128).collect();
    let count = samples.len() as i128;
    let (sum, squares) = (whole.iter().sum::<i128>(), whole.iter().map(|it| it * it).sum::<i128>());
    let right = (count * squares - sum * sum) as f64 / (count * (count - 1)) as f64 / unit / unit;
    !((found / right - 1.0).abs() <= 0.01)
}

/// MC-05: means of long lists.
pub(super) const LONG: Case = Case {
    id: "MC-05",
    chapter: CHAPTER,
    input: "the mean of 10^6 to 2 10^7 equal numbers",
    most: LISTS.len() as u64,
    naive_fails: |trial| {
        let (number, count) = LISTS[trial as usize];
        is_not_mean(number, naive::mean_of_equal(number, count))
    },
    robust_fails: |trial| {
        let (number, count) = LISTS[trial as usize];
        let running: Running = (0..count).map(|_| f64::from(number)).collect();
        is_not_mean(number, running.mean() as f32)
    },
};

/// A number, and how many of it.
const LISTS: [(f32, u32); 4] =
    [(0.1, 1_000_000), (0.3, 5_000_000), (1.0, 20_000_000), (0.7, 10_000_000)];

fn is_not_mean(number: f32, found: f32) -> bool {
    !((found / number - 1.0).abs() <= 1e-6)
}
