//! A lamp that stands on the floor, ever nearer: what it costs to choose its points by solid angle.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, Table};
use common::film::Color;
use common::sampler::Stream;
use common::stats::running::Running;
use glam::Vec3;
use path_tracing::part::Emission;
use path_tracing::space::Piece;

use crate::lamp::{Lamp, Way};
use crate::polygon::irradiance;

/// Estimates of a run.
const ESTIMATES: u64 = 40_000;
const GAPS: [f32; 4] = [1.0, 0.1, 0.01, 0.001];

/// The two ways at four distances.
pub(super) fn experiment() -> Experiment<'static> {
    let rows = |series, way| GAPS.into_iter().filter_map(move |gap| method(series, way, gap));
    Experiment {
        name: "near",
        title: "The light of a triangle that stands on the floor, nearer and nearer",
        work_unit: "estimates",
        error_metric: "RMS relative error of one estimate against Lambert's closed form",
        plot: Plot::ErrorOver {
            size: "the lamp's distance over its width",
            error: "error of one estimate",
        },
        methods: rows("by area", Way::Area)
            .chain(rows("by solid angle", Way::SolidAngle))
            .collect(),
        note,
    }
}

/// None if the lamp has no area.
fn method(series: &'static str, way: Way, gap: f32) -> Option<Method<'static>> {
    let corners = [[-0.5, gap, 0.0], [0.5, gap, 0.0], [0.1, gap, 0.5]].map(Vec3::from_array);
    let emission = Emission { radiance: Color::ONE, both_sides: true };
    let lamp = Lamp::new(Piece::Triangle(corners), emission)?;
    let right = irradiance(&corners.map(Vec3::as_dvec3), glam::DVec3::Z);
    let samples: Running = (0..ESTIMATES).map(|trial| estimate(&lamp, way, trial)).collect();
    let off = samples.mean() - right;
    let error = (samples.variance()? + off * off).sqrt() / right;
    Some(Method {
        label: format!("{series}, at {gap}"),
        series,
        size: f64::from(gap),
        work: ESTIMATES,
        error,
        run: Box::new(move || {
            let sum: f64 = (0..ESTIMATES).map(|trial| estimate(&lamp, way, trial)).sum();
            black_box(sum);
        }),
    })
}

/// One estimate of the irradiance of a floor at the origin.
fn estimate(lamp: &Lamp, way: Way, trial: u64) -> f64 {
    let u = Stream::of_trial(1350, trial).uniform2();
    let point = lamp.point(Vec3::ZERO, way, u);
    point.map_or(0.0, |point| f64::from(point.direction.z.max(0.0) / point.pdf))
}

fn note(table: &Table) -> String {
    let row = |label: &str| table.rows.iter().find(|row| row.label == label);
    let (Some(area), Some(angle)) = (row("by area, at 1"), row("by solid angle, at 1")) else {
        return String::new();
    };
    format!(
        "At the distance of its width, a point by solid angle takes {:.1} times the time of one by area.",
        angle.nanoseconds() / area.nanoseconds()
    )
}

#[cfg(test)]
mod tests {
    use super::experiment;

    #[test]
    fn by_area_the_error_grows_and_by_solid_angle_it_does_not() {
        let methods = experiment().methods;
        let [far, .., near] = &methods[..4] else { panic!("four distances") };
        assert!(near.error > 5.0 * far.error, "{} {}", far.error, near.error);
        assert!(methods[4..].iter().all(|row| row.error < 1.0));
    }
}
