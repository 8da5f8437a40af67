//! MF-10: a test that can't see what it tests.

use std::f64::consts::{FRAC_PI_2, TAU};

use common::hard::Case;
use common::sampler::Stream;
use common::stats::chi_squared::goodness_of_fit;
use glam::Vec3;

use super::CHAPTER;
use crate::ggx::Ggx;

const ROUGHNESSES: [f32; 8] = [0.5, 0.3, 0.1, 0.05, 0.01, 3e-3, 1e-3, 1e-4];
const SAMPLES: u64 = 50_000;
const WIDER: f32 = 1.1;

/// MF-10: χ² must take the right sampler, and refuse one that is a tenth too wide.
pub(super) const BLIND: Case = Case {
    id: "MF-10",
    chapter: CHAPTER,
    input: "a χ² test of normals, against a lobe that is 10 % too wide",
    most: ROUGHNESSES.len() as u64,
    naive_fails: |trial| is_blind(trial, &GLOBE),
    robust_fails: |trial| is_blind(trial, &LOBE),
};

/// A histogram of normals: in how many rows and columns, and in which row of them, from 0 to 1, is
/// one whose tangent is `slope`. `share` is the part of all that lies below a row.
struct Bins {
    rows: usize,
    columns: usize,
    row: fn(slope: f64, alpha: f64) -> f64,
    share: fn(row: f64, alpha: f64) -> f64,
}

/// Equal steps of both angles, as in the tests of the best-known renderers.
const GLOBE: Bins = Bins {
    rows: 80,
    columns: 160,
    row: |slope, _| libm::atan(slope) / FRAC_PI_2,
    share: |row, alpha| {
        let slope = libm::tan(row * FRAC_PI_2);
        slope * slope / (alpha * alpha + slope * slope)
    },
};

/// Equal shares of the lobe.
const LOBE: Bins = Bins {
    rows: 16,
    columns: 4,
    row: |slope, alpha| slope * slope / (alpha * alpha + slope * slope),
    share: |row, _| row,
};

fn is_blind(trial: u64, bins: &Bins) -> bool {
    let alpha = ROUGHNESSES[trial as usize];
    let p_value = |sampled: f32| {
        let mut observed = vec![0; bins.rows * bins.columns];
        for sample in 0..SAMPLES {
            let u = Stream::of_trial(1519, trial * SAMPLES + sample).uniform2();
            observed[bins.of(Ggx { alpha: sampled }.normal(u), f64::from(alpha))] += 1;
        }
        let expected = bins.expected(f64::from(alpha));
        goodness_of_fit(&observed, &expected).map_or(f64::NAN, |fit| fit.p_value)
    };
    !(p_value(alpha) >= 1e-4 && p_value(alpha * WIDER) < 1e-4)
}

impl Bins {
    fn of(&self, normal: Vec3, alpha: f64) -> usize {
        let normal = normal.as_dvec3();
        let row = (self.row)(normal.truncate().length() / normal.z, alpha);
        let turn = libm::atan2(normal.y, normal.x) / TAU + 0.5;
        let index = |part: f64, count: usize| ((part * count as f64) as usize).min(count - 1);
        index(row, self.rows) * self.columns + index(turn, self.columns)
    }

    fn expected(&self, alpha: f64) -> Vec<f64> {
        let below = |row: usize| (self.share)(row as f64 / self.rows as f64, alpha);
        let of_row = |row: usize| {
            // The tangent of a right angle is not quite infinite.
            let above = if row + 1 == self.rows { 1.0 } else { below(row + 1) };
            SAMPLES as f64 * (above - below(row)) / self.columns as f64
        };
        let rows = (0..self.rows).flat_map(|row| vec![of_row(row); self.columns]);
        rows.collect()
    }
}
