//! One integral by several densities, one of them with an infinite variance.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, no_note};

use crate::convergence::error;
use crate::estimator::mean;
use crate::points::Points;
use crate::power::{Power, THIRD};

const SEEDS: u64 = 1024;
const COUNT: u32 = 256;
const WORK: u32 = 1 << 16;

pub(super) fn experiment() -> Experiment<'static> {
    Experiment {
        name: "densities",
        title: "The integral of x^2 from 0 to 1 by densities (k + 1) x^k",
        work_unit: "samples",
        error_metric: "RMS error of means of 256 samples against 1/3, over 1024 seeds",
        plot: Plot::ErrorOverTime("error (RMS)"),
        methods: [0, 1, 2, 8].map(method).into(),
        note: no_note,
    }
}

fn method(exponent: u8) -> Method<'static> {
    let power = Power { exponent: f32::from(exponent) };
    Method {
        label: format!("k = {exponent}"),
        series: "densities",
        size: f64::from(exponent),
        work: u64::from(WORK),
        error: error(Points::Random, COUNT, SEEDS, THIRD, |u| power.sample(u.x)),
        run: Box::new(move || {
            for seed in 0..u64::from(WORK / COUNT) {
                let sample =
                    |index| black_box(power).sample(Points::Random.at(index, COUNT, seed).x);
                black_box(mean(COUNT, sample).mean());
            }
        }),
    }
}
