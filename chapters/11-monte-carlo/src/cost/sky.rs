//! The light of a sky: by uniform directions, by the cosine, and by even points.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, Table};
use glam::Vec2;

use crate::convergence::{error, slope};
use crate::estimator::{Sample, mean};
use crate::points::Points;
use crate::sky;

/// Over so many seeds an error is known to a 22nd part.
const SEEDS: u64 = 256;
const COUNTS: [u32; 3] = [16, 128, 1024];
/// Samples in a run.
const WORK: u32 = 1 << 16;

type Strategy = fn(Vec2) -> Sample;

const SERIES: [(&str, Points, Strategy); 4] = [
    ("uniform", Points::Random, sky::uniform),
    ("cosine", Points::Random, sky::cosine),
    ("cosine, stratified", Points::Stratified, sky::cosine),
    ("cosine, Sobol", Points::Sobol, sky::cosine),
];

pub(super) fn experiment() -> Experiment<'static> {
    let methods = SERIES.into_iter().flat_map(|series| COUNTS.map(|count| method(series, count)));
    Experiment {
        name: "sky",
        title: "The light of a cloudy sky, an integral over directions",
        work_unit: "samples",
        error_metric: "RMS error of the mean against 7 pi / 9, over 256 seeds",
        plot: Plot::ErrorOver { size: "samples in a mean", error: "error (RMS)" },
        methods: methods.collect(),
        note,
    }
}

fn method(
    (series, points, strategy): (&'static str, Points, Strategy),
    count: u32,
) -> Method<'static> {
    Method {
        label: format!("{series}, {count}"),
        series,
        size: f64::from(count),
        work: u64::from(WORK),
        error: error(points, count, SEEDS, sky::IRRADIANCE, strategy),
        run: Box::new(move || {
            for seed in 0..u64::from(WORK / count) {
                let sample = |index| strategy(points.at(index, black_box(count), seed));
                black_box(mean(count, sample).mean());
            }
        }),
    }
}

/// How fast each error falls.
fn note(table: &Table) -> String {
    let slope_of = |series: &str| {
        let rows: Vec<_> = table.rows.iter().filter(|row| row.series == series).collect();
        let (first, last) = (rows.first()?, rows.last()?);
        let slope = slope([first.size as u32, last.size as u32], [first.error, last.error]);
        Some(format!("{series}: N^{slope:.2}"))
    };
    let slopes: Vec<String> = SERIES.iter().filter_map(|series| slope_of(series.0)).collect();
    format!("With N samples the error falls as: {}.", slopes.join("; "))
}
