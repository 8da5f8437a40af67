//! What a depth leaves out.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, Table};
use common::sampler::Sampler;
use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::furnace;
use crate::smooth::Smooth;
use crate::stage::Stage;
use crate::strategy::{ByDirection, Never};
use crate::tracer::PathTracer;

const PATHS: u64 = 64;
const RAY: Ray = Ray { origin: Vec3::new(0.1, -0.2, 0.3), direction: Vec3::X };

const GREY: &str = "albedo 0.5";
const BRIGHT: &str = "albedo 0.9";

/// Furnaces: the part of their light that a depth leaves out.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let mut methods = Vec::new();
    for (series, albedo) in [(GREY, 0.5), (BRIGHT, 0.9)] {
        let stage = Rc::new(Stage::new(&furnace::ball(albedo)).ok()?);
        let depths = [0, 1, 3, 7, 15];
        methods.extend(depths.map(|depth| method(&stage, series, f64::from(albedo), depth)));
    }
    Some(Experiment {
        name: "truncation",
        title: "A furnace: what is left out when a path ends at a depth",
        work_unit: "paths",
        error_metric: "missing part of 1 / (1 - albedo)",
        plot: Plot::ErrorOver { size: "surfaces seen", error: "missing part" },
        methods,
        note,
    })
}

fn method(
    stage: &Rc<Stage<Smooth>>,
    series: &'static str,
    albedo: f64,
    depth: u32,
) -> Method<'static> {
    let whole = 1.0 / (1.0 - albedo);
    let error = (whole - mean(stage, depth)).abs() / whole;
    let stage = Rc::clone(stage);
    Method {
        label: format!("{series}, depth {depth}"),
        series,
        size: f64::from(depth) + 1.0,
        work: PATHS,
        error,
        run: Box::new(move || {
            black_box(mean(&stage, depth));
        }),
    }
}

fn mean(stage: &Stage<Smooth>, depth: u32) -> f64 {
    let world = stage.world();
    let (lighting, ending) = (ByDirection, Never);
    let tracer: PathTracer<_, _, _, true, false> =
        PathTracer { world: &world, lighting, ending, depth };
    let path = |path| {
        let sampler = Sampler::new(1202, path, 0, 1);
        f64::from(tracer.radiance(black_box(RAY), &sampler, &mut Off).y)
    };
    (0..PATHS).map(path).sum::<f64>() / PATHS as f64
}

/// How near the measured parts are to a to the power of the surfaces that were seen.
fn note(table: &Table) -> String {
    let off = table.rows.iter().map(|row| {
        let albedo: f64 = if row.series == GREY { 0.5 } else { 0.9 };
        let closed = (0..row.size as u32).fold(1.0, |part, _| albedo * part);
        (row.error - closed).abs()
    });
    format!(
        "The missing part is the albedo to the power of the surfaces seen: no row is further from \
         that than {:.0e}.",
        off.fold(0.0, f64::max)
    )
}
