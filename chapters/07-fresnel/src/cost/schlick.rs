//! Where Schlick's approximation is near: over indices, and over angles.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, no_note};
use common::math;

use super::by_sines;
use crate::index::Index;
use crate::interface::Interface;
use crate::schlick;

/// Angles in a range, and calls a run.
const STEPS: u32 = 1000;
const REPEATS: u32 = 20;

/// The worst angle for each index.
pub(super) fn over_indices() -> Experiment<'static> {
    let indices = [1.01, 1.1, 1.33, 1.5, 2.0, 2.42, 4.0];
    let method = |number: f32| {
        let index = Index::new(number).ok()?;
        let into = Interface::new(Index::AIR, index);
        Some(method(format!("index {number}"), into, [0.0, 90.0]))
    };
    Experiment {
        name: "schlick-index",
        title: "Schlick's approximation for light that enters media of several indices",
        methods: indices.into_iter().filter_map(method).collect(),
        ..blank()
    }
}

/// The worst angle of each range, for glass.
pub(super) fn over_angles() -> Experiment<'static> {
    let glass = Interface::new(Index::AIR, Index::GLASS);
    let edges = [0.0, 15.0, 30.0, 45.0, 60.0, 70.0, 80.0, 85.0, 90.0];
    let ranges = edges.windows(2).map(|range| [range[0], range[1]]);
    let method =
        |range: [f32; 2]| method(format!("{} to {} degrees", range[0], range[1]), glass, range);
    Experiment {
        name: "schlick-angle",
        title: "Schlick's approximation for light that enters glass at several angles",
        methods: ranges.map(method).collect(),
        ..blank()
    }
}

fn blank() -> Experiment<'static> {
    Experiment {
        name: "",
        title: "",
        work_unit: "reflectances",
        error_metric: "largest error of the reflected part against Fresnel's equations by sines",
        plot: Plot::ErrorOverTime("largest error of the part"),
        methods: Vec::new(),
        note: no_note,
    }
}

/// Schlick's approximation on one interface, for angles in a range of degrees.
fn method(label: String, interface: Interface, [low, high]: [f32; 2]) -> Method<'static> {
    let angle = move |step: u32| low + (high - low) * step as f32 / STEPS as f32;
    let cosine = move |step| f64::from(math::cos(angle(step).to_radians()));
    let cosines: Vec<f64> = (0..=STEPS).map(cosine).collect();
    let error = |&cosine: &f64| {
        (schlick::reflectance(&interface, cosine) - by_sines(&interface, cosine)).abs()
    };
    Method {
        error: cosines.iter().map(error).fold(0.0, f64::max),
        label,
        series: "Schlick",
        size: 1.0,
        work: u64::from(REPEATS) * cosines.len() as u64,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                let parts = black_box(&cosines).iter();
                black_box(parts.map(|&it| schlick::reflectance(&interface, it)).sum::<f64>());
            }
        }),
    }
}
