//! Ways to give a vector length 1: error against nanoseconds.

use std::hint::black_box;
use std::sync::Arc;

use common::cost::{Experiment, Method, Plot, no_note};
use common::math;
use common::sampler::Stream;
use glam::Vec3;

use super::root_mean_square;
use crate::direction::unit;

const VECTORS: u64 = 8192;
const REPEATS: u64 = 16;

/// Three ways on the same vectors.
pub(super) fn experiment() -> Experiment<'static> {
    let vectors: Arc<Vec<Vec3>> = Arc::new((0..VECTORS).map(vector).collect());
    Experiment {
        name: "directions",
        title: "A vector scaled to length 1: one vector in a thousand very long or very short",
        work_unit: "vectors",
        error_metric: "RMS of the length's distance from 1, at most 1 each, against f64",
        plot: Plot::ErrorOverTime("error of the length (RMS)"),
        methods: vec![
            method("glam normalize", &vectors, |vector| vector.normalize()),
            method("divide by length", &vectors, |vector| vector / vector.length()),
            method("unit", &vectors, |vector| unit(vector).unwrap_or(Vec3::ZERO)),
            method("f64", &vectors, |vector| vector.as_dvec3().normalize().as_vec3()),
        ],
        note: no_note,
    }
}

fn vector(number: u64) -> Vec3 {
    let mut stream = Stream::of_trial(302, number);
    let mut component = || stream.between(-3.0, 5.0);
    let vector = Vec3::new(component(), component(), component());
    if number % 1024 == 7 { vector * math::pow(10.0, stream.between(-35.0, 35.0)) } else { vector }
}

fn method<F>(label: &'static str, vectors: &Arc<Vec<Vec3>>, direction: F) -> Method<'static>
where
    F: Fn(Vec3) -> Vec3 + 'static,
{
    let length_error = |vector: &Vec3| (direction(*vector).as_dvec3().length() - 1.0).abs();
    let error = root_mean_square(vectors.iter().map(length_error));
    let vectors = vectors.clone();
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: REPEATS * VECTORS,
        error,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                let sum: Vec3 = black_box(&*vectors).iter().map(|vector| direction(*vector)).sum();
                black_box(sum);
            }
        }),
    }
}
