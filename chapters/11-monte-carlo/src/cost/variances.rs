//! The variance of numbers around 1000, three ways.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, no_note};
use common::sampler::Stream;
use common::stats::running::Running;

use crate::naive;

const SAMPLES: usize = 4096;
const REPEATS: u64 = 16;

pub(super) fn experiment() -> Experiment<'static> {
    let mut stream = Stream::of_trial(1130, 0);
    let samples: Rc<Vec<f32>> =
        Rc::new((0..SAMPLES).map(|_| stream.between(1000.0, 1001.0)).collect());
    Experiment {
        name: "variance",
        title: "The variance of 4096 numbers between 1000 and 1001",
        work_unit: "numbers",
        error_metric: "relative error against the sum of squared deviations, in two passes and f64",
        plot: Plot::ErrorOverTime("relative error"),
        methods: vec![
            method("mean of squares, f32", &samples, |it| {
                f64::from(naive::variance(it)) * SAMPLES as f64 / (SAMPLES - 1) as f64
            }),
            method("mean of squares, f64", &samples, in_double),
            method("Welford, f64", &samples, |it| {
                let running: Running = it.iter().map(|&number| f64::from(number)).collect();
                running.variance().unwrap_or(f64::NAN)
            }),
        ],
        note: no_note,
    }
}

/// The naive formula, with twice the digits.
fn in_double(samples: &[f32]) -> f64 {
    let count = samples.len() as f64;
    let numbers = || samples.iter().map(|&number| f64::from(number));
    let (sum, squares) = (numbers().sum::<f64>(), numbers().map(|it| it * it).sum::<f64>());
    (squares - sum * sum / count) / (count - 1.0)
}

/// First the mean, then the squared deviations from it.
fn oracle(samples: &[f32]) -> f64 {
    let count = samples.len() as f64;
    let numbers = || samples.iter().map(|&number| f64::from(number));
    let mean = numbers().sum::<f64>() / count;
    numbers().map(|it| (it - mean) * (it - mean)).sum::<f64>() / (count - 1.0)
}

fn method(
    label: &'static str,
    samples: &Rc<Vec<f32>>,
    variance: fn(&[f32]) -> f64,
) -> Method<'static> {
    let samples = samples.clone();
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: REPEATS * SAMPLES as u64,
        error: (variance(&samples) / oracle(&samples) - 1.0).abs(),
        run: Box::new(move || {
            for _ in 0..REPEATS {
                black_box(variance(black_box(&samples)));
            }
        }),
    }
}
