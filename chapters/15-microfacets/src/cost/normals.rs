//! Visible normals against all normals: the noise that each leaves, and its time.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, Table};
use glam::Vec3;
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;

use crate::albedo::albedo;
use crate::conductor::PERFECT;
use crate::facets::{Masking, Normals};
use crate::rough::Rough;

const ESTIMATES: u64 = 1_000;
/// Two thirds of the way from the vertical to the horizon.
const OUTGOING: Vec3 = Vec3::new(0.866_025_4, 0.0, 0.5);
const GRAZING: Vec3 = Vec3::new(0.994_987_4, 0.0, 0.1);

/// The light that a rough metal sends from a white sky, by few samples and by many.
pub(super) fn experiment() -> Experiment<'static> {
    let mut methods = Vec::new();
    for (place, outgoing) in [("60 degrees", OUTGOING), ("84 degrees", GRAZING)] {
        for normals in [Normals::Visible, Normals::All] {
            for count in [4, 16, 64] {
                methods.push(method(place, outgoing, normals, count));
            }
        }
    }
    Experiment {
        name: "normals",
        title: "The light that metal of roughness 0.5 sends back: which normals are chosen",
        work_unit: "estimates",
        error_metric: "RMS error of the reflected part against a sum in f64",
        plot: Plot::ErrorOverTime("error of the part (RMS)"),
        methods,
        note,
    }
}

fn method(place: &'static str, outgoing: Vec3, normals: Normals, count: u64) -> Method<'static> {
    let mut material = Rough::metal(PERFECT, 0.5);
    material.facets_mut().normals = normals;
    let right = albedo(0.5, f64::from(outgoing.z), Masking::Correlated, 400);
    let estimate = move |number: u64| {
        let weight = |sample: u64| {
            let random = Random::of_trial(1531, number * count + sample);
            material.sample(outgoing, &random).map_or(0.0, |it| f64::from(it.weight.x))
        };
        (0..count).map(weight).sum::<f64>() / count as f64
    };
    let squares = (0..ESTIMATES).map(|number| estimate(number) - right).map(|error| error * error);
    let series = match (normals, place) {
        (Normals::Visible, "60 degrees") => "visible normals, 60 degrees",
        (Normals::Visible, _) => "visible normals, 84 degrees",
        (Normals::All, "60 degrees") => "all normals, 60 degrees",
        (Normals::All, _) => "all normals, 84 degrees",
    };
    Method {
        error: (squares.sum::<f64>() / ESTIMATES as f64).sqrt(),
        label: format!("{series}, samples: {count}"),
        series,
        size: count as f64,
        work: ESTIMATES,
        run: Box::new(move || {
            for number in 0..ESTIMATES {
                black_box(estimate(black_box(number)));
            }
        }),
    }
}

fn note(table: &Table) -> String {
    let of = |label: &str| table.rows.iter().find(|row| row.label == label);
    let ratio = |place: &str| {
        let visible = of(&format!("visible normals, {place}, samples: 64"))?;
        let all = of(&format!("all normals, {place}, samples: 64"))?;
        Some((all.error / visible.error) * (all.error / visible.error))
    };
    match (ratio("60 degrees"), ratio("84 degrees")) {
        (Some(steep), Some(grazing)) => format!(
            "For the error of visible normals, all normals need {steep:.1} times the samples at 60 \
             degrees and {grazing:.0} times at 84."
        ),
        _ => String::new(),
    }
}
