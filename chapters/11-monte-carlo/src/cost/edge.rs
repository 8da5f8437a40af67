//! The area of a quarter of a disk: an integrand with an edge.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, no_note};
use glam::Vec2;

use crate::convergence::error;
use crate::estimator::{Sample, mean};
use crate::points::Points;

const SEEDS: u64 = 256;
const COUNTS: [u32; 2] = [16, 1024];
const WORK: u32 = 1 << 16;

pub(super) fn experiment() -> Experiment<'static> {
    let methods =
        Points::ALL.into_iter().flat_map(|points| COUNTS.map(|count| method(points, count)));
    Experiment {
        name: "edge",
        title: "The area of a quarter of a disk: 1 inside of the edge, 0 outside",
        work_unit: "samples",
        error_metric: "RMS error of the mean against pi / 4, over 256 seeds",
        plot: Plot::ErrorOver { size: "samples in a mean", error: "error (RMS)" },
        methods: methods.collect(),
        note: no_note,
    }
}

/// 1 where the point is in the disk around the corner.
fn inside(u: Vec2) -> Sample {
    let value = if u.length_squared() < 1.0 { 1.0 } else { 0.0 };
    Sample { value, density: 1.0 }
}

fn method(points: Points, count: u32) -> Method<'static> {
    Method {
        label: format!("{}, {count}", points.name()),
        series: points.name(),
        size: f64::from(count),
        work: u64::from(WORK),
        error: error(points, count, SEEDS, std::f64::consts::FRAC_PI_4, inside),
        run: Box::new(move || {
            for seed in 0..u64::from(WORK / count) {
                let sample = |index| inside(points.at(index, black_box(count), seed));
                black_box(mean(count, sample).mean());
            }
        }),
    }
}
