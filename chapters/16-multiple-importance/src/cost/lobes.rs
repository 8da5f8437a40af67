//! One lamp over lobes of several widths: how far single estimates spread.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, no_note};
use common::sampler::Stream;
use common::stats::running::Running;
use glam::Vec2;
use monte_carlo::warp::cap::Cap;

use crate::heuristic::Heuristic;
use crate::place::Place;

type Estimate = fn(&Place, [Vec2; 2]) -> f32;

const SAMPLES: u64 = 20_000;
/// From a matte surface to a lobe narrower than the lamp.
const EXPONENTS: [f32; 4] = [1.0, 10.0, 100.0, 1_000.0];

/// The strategies: alone, and combined.
const STRATEGIES: [(&str, Estimate); 4] = [
    ("light", |place, [u, _]| place.by_light(u)),
    ("direction", |place, [_, u]| place.by_direction(u)),
    ("balance", |place, u| place.combined(Heuristic::Balance, u)),
    ("power", |place, u| place.combined(Heuristic::Power, u)),
];

/// The spread over the lobe's exponent, a curve a strategy.
pub(super) fn experiment() -> Experiment<'static> {
    let methods = EXPONENTS.into_iter().flat_map(|exponent| {
        STRATEGIES.into_iter().map(move |(series, estimate)| method(series, exponent, estimate))
    });
    Experiment {
        name: "lobes",
        title: "One lamp, 10 degrees wide, over surfaces of several exponents",
        work_unit: "estimates",
        error_metric: "standard deviation of one estimate, in units of the closed form",
        plot: Plot::ErrorOver {
            size: "the lobe's exponent",
            error: "standard deviation / right value",
        },
        methods: methods.collect(),
        note: no_note,
    }
}

fn method(series: &'static str, exponent: f32, estimate: Estimate) -> Method<'static> {
    let place = Place { exponent, lamp: Cap { height: 0.003_8 }, radiance: 1.0 };
    let square = |value: f32| {
        let error = f64::from(value) / place.exact() - 1.0;
        error * error
    };
    let squares: Running = samples(place, estimate).map(square).collect();
    Method {
        label: format!("{series}, exponent {exponent}"),
        series,
        size: f64::from(exponent),
        work: SAMPLES,
        error: squares.mean().sqrt(),
        run: Box::new(move || {
            black_box(samples(black_box(place), estimate).sum::<f32>());
        }),
    }
}

fn samples(place: Place, estimate: Estimate) -> impl Iterator<Item = f32> {
    (0..SAMPLES).map(move |trial| {
        let mut stream = Stream::of_trial(1610, trial);
        estimate(&place, [stream.uniform2(), stream.uniform2()])
    })
}
