//! What the plan saves: a matte scene with materials that can be rough, and without.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, Table, change};
use common::film::Color;
use common::sampler::Sampler;
use common::tally::Off;
use glam::Vec2;
use path_tracing::bsdf::Bsdf;
use path_tracing::lambert::Lambert;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::strategy::{ByDirection, Never};
use path_tracing::tracer::PathTracer;
use path_tracing::world::World;

use crate::finish::Finish;
use crate::scenes;

const SIDE: u32 = 64;
const SAMPLES: u32 = 4;

/// The Cornell box with three sets of materials, and with metal.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let stage = |name| Some(Rc::new(Stage::new(&scenes::named(name, 0.5).ok()?).ok()?));
    let (matte, metals) = (stage("cornell")?, stage("rough-metals")?);
    Some(Experiment {
        name: "plan",
        title: "The matte Cornell box, 64x64: what is not called for costs nothing",
        work_unit: "paths",
        error_metric: "largest difference from the picture with all materials",
        plot: Plot::ErrorOverTime("difference"),
        methods: vec![
            method("matte, needed", &matte, drawn::<Lambert>(Finish::lambert)),
            method("matte, with mirrors and glass", &matte, drawn::<Smooth>(Finish::smooth)),
            method("matte, all", &matte, all),
            method("metal, all", &metals, all),
        ],
        note,
    })
}

fn method(
    label: &'static str,
    stage: &Rc<Stage<Finish>>,
    draw: impl Fn(&Stage<Finish>) -> Vec<Color> + 'static,
) -> Method<'static> {
    let apart = |(one, other): (Color, Color)| f64::from((one - other).abs().max_element());
    let stage = Rc::clone(stage);
    Method {
        error: draw(&stage).into_iter().zip(all(&stage)).map(apart).fold(0.0, f64::max),
        label: label.into(),
        series: label,
        size: 1.0,
        work: u64::from(SIDE * SIDE * SAMPLES),
        run: Box::new(move || drop(black_box(draw(&stage)))),
    }
}

/// With materials that are simpler, and none if there is one that isn't.
fn drawn<B: Bsdf + 'static>(
    narrow: fn(&Finish) -> Option<B>,
) -> impl Fn(&Stage<Finish>) -> Vec<Color> + 'static {
    move |stage| {
        stage.world().narrowed(narrow).map_or_else(Vec::new, |world| picture(&world, stage))
    }
}

fn all(stage: &Stage<Finish>) -> Vec<Color> {
    picture(&stage.world(), stage)
}

fn picture<B: Bsdf>(world: &World<B>, stage: &Stage<Finish>) -> Vec<Color> {
    let (lighting, ending, depth) = (ByDirection, Never, 8);
    let tracer = PathTracer::<B, _, _, true, false> { world, lighting, ending, depth };
    let camera = stage.camera.with_film(SIDE, SIDE);
    let radiance = |number: u32| {
        let (pixel, sample) = (number / SAMPLES, number % SAMPLES);
        let place = Vec2::new((pixel % SIDE) as f32 + 0.5, (pixel / SIDE) as f32 + 0.5);
        let sampler = Sampler::new(1, u64::from(pixel), sample, SAMPLES);
        tracer.radiance(camera.ray(place), &sampler, &mut Off)
    };
    (0..SIDE * SIDE * SAMPLES).map(radiance).collect()
}

fn note(table: &Table) -> String {
    let [needed, smooth, all, ..] = &table.rows[..] else { return String::new() };
    format!(
        "Against what is needed, materials that can be mirrors or glass take {} time, and those that \
         can be rough take {}.",
        change(smooth.nanoseconds() / needed.nanoseconds()),
        change(all.nanoseconds() / needed.nanoseconds())
    )
}
