//! MI-06: what the mean of many estimates is, against the closed form.

use common::hard::Case;
use common::sampler::Stream;
use common::stats::running::Running;
use glam::Vec2;
use monte_carlo::warp::cap::Cap;

use super::CHAPTER;
use crate::heuristic::Heuristic;
use crate::naive::added;
use crate::place::Place;

/// A right mean is farther off than this once in two million times.
const DEVIATIONS: f64 = 5.0;
const SAMPLES: u64 = 4000;
/// What is found less than twenty times in so many samples may be missing, and its spread with it.
const RARE: f64 = 20.0 / SAMPLES as f64;

/// MI-06: lobes and lamps of many widths.
pub(super) const AGREE: Case = Case {
    id: "MI-06",
    chapter: CHAPTER,
    input: "the mean of both strategies, 300 lobes and lamps, against the closed form",
    most: 300,
    naive_fails: |trial| is_off(trial, added),
    robust_fails: |trial| {
        is_off(trial, |place, u| place.combined(Heuristic::Balance, u))
            || is_off(trial, |place, u| place.combined(Heuristic::Power, u))
    },
};

fn place(trial: u64) -> Place {
    let mut stream = Stream::of_trial(1601, trial);
    let mut decades = |low, high| common::math::pow(10.0, stream.between(low, high));
    Place { exponent: decades(0.0, 3.5), lamp: Cap { height: decades(-4.0, -0.1) }, radiance: 1.0 }
}

/// Whether chance doesn't explain how far the mean is off.
fn is_off(trial: u64, estimate: fn(&Place, [Vec2; 2]) -> f32) -> bool {
    let place = place(trial);
    let one = |sample| {
        let mut stream = Stream::of_trial(1602 + trial, sample);
        f64::from(estimate(&place, [stream.uniform2(), stream.uniform2()]))
    };
    let samples: Running = (0..SAMPLES).map(one).collect();
    let error = samples.standard_error().unwrap_or(0.0);
    !((samples.mean() - place.exact()).abs() <= DEVIATIONS * error + RARE * place.exact())
}
