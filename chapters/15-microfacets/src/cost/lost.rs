//! How much light a surface loses, over its roughness, by both kinds of masking.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, no_note};
use common::sampler::Stream;
use glam::Vec3;
use monte_carlo::warp::hemisphere;
use path_tracing::bsdf::Bsdf;

use crate::albedo::albedo;
use crate::conductor::PERFECT;
use crate::facets::Masking;
use crate::rough::Rough;

const PAIRS: u64 = 4_096;

/// Five roughnesses, twice.
pub(super) fn experiment() -> Experiment<'static> {
    let masking = [("correlated", Masking::Correlated), ("separable", Masking::Separable)];
    let methods = masking.into_iter().flat_map(|(series, masking)| {
        [0.1, 0.25, 0.5, 0.75, 1.0].map(|alpha| method(series, masking, alpha))
    });
    Experiment {
        name: "lost",
        title: "Facets that reflect everything: how much of it gets lost",
        work_unit: "values of the BRDF",
        error_metric: "the part of a white sky's light that is not sent back, a sum in f64",
        plot: Plot::ErrorOver { size: "roughness", error: "light that is lost" },
        methods: methods.collect(),
        note: no_note,
    }
}

fn method(series: &'static str, masking: Masking, alpha: f32) -> Method<'static> {
    let mut material = Rough::metal(PERFECT, alpha);
    material.facets_mut().masking = masking;
    let direction = |number| hemisphere::cosine(Stream::of_trial(1532, number).uniform2());
    let pairs: Vec<[Vec3; 2]> =
        (0..PAIRS).map(|pair| [direction(2 * pair), direction(2 * pair + 1)]).collect();
    Method {
        error: 1.0 - sent_back(f64::from(alpha), masking),
        label: format!("{series}, roughness {alpha}"),
        series,
        size: f64::from(alpha),
        work: PAIRS,
        run: Box::new(move || {
            let value = |&[outgoing, incoming]: &[Vec3; 2]| material.eval(outgoing, incoming);
            black_box(black_box(&pairs).iter().map(value).sum::<Vec3>());
        }),
    }
}

/// The part that is sent back in all directions together: the mean over cosines, each as often as it
/// counts.
fn sent_back(alpha: f64, masking: Masking) -> f64 {
    const STEPS: u32 = 20;
    let cosine = |step: u32| ((f64::from(step) + 0.5) / f64::from(STEPS)).sqrt();
    (0..STEPS).map(|step| albedo(alpha, cosine(step), masking, 60)).sum::<f64>() / f64::from(STEPS)
}
