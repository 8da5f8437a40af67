//! What the plan saves: a scene with the effects it calls for, with all, and by a loop that was
//! written for it alone.

use std::hint::black_box;
use std::sync::Arc;

use common::chapter::Failure;
use common::cost::{Experiment, Method, Plot, Row, Table};
use common::film::{Color, Film};
use common::plan::{Plan, Simulate};
use common::render::{Settings, render};
use common::stats::error::film_rmse;
use common::tally::Off;

use crate::command::SKILLS;
use crate::models::{Blinn, Model};
use crate::picture::Picture;
use crate::scenes::{Stage, brute_force};
use crate::shading::facing;

/// One thread, so that the median is of the loop and not of who else was running.
fn settings() -> Settings {
    Settings { width: 320, height: 240, threads: 1, ..Settings::default() }
}

pub(super) fn experiment() -> Result<Experiment<'static>, Failure> {
    let mut methods = scene(1, "low-lamp", lit_by_hand)?;
    methods.extend(scene(2, "dark", dark_by_hand)?);
    methods.extend(scene(3, "empty", empty_by_hand)?);
    Ok(Experiment {
        name: "plans",
        title: "What the plan saves: a scene's own effects, all effects, and a loop made for the scene",
        work_unit: "pixels",
        error_metric: "RMS difference of the picture from that with all effects",
        plot: Plot::TimeOver("the scene: 1 is low-lamp, 2 is dark, 3 is empty"),
        methods,
        note,
    })
}

/// The three ways to draw a scene, which has a number of its own on the plot.
fn scene(
    number: u32,
    name: &'static str,
    by_hand: fn(&Stage) -> Film,
) -> Result<Vec<Method<'static>>, Failure> {
    let stage = Arc::new(Stage::named(name, brute_force)?);
    let reference = by_plan(&stage, Simulate::All);
    let method = |way: &'static str, draw: fn(&Stage) -> Film| {
        let (stage, Settings { width, height, .. }) = (stage.clone(), settings());
        Method {
            label: format!("{name}, {way}"),
            series: way,
            size: f64::from(number),
            work: u64::from(width) * u64::from(height),
            error: film_rmse(&reference, &draw(&stage)).unwrap_or(f64::NAN),
            run: Box::new(move || {
                black_box(draw(&stage));
            }),
        }
    };
    Ok(vec![
        method("as called for", |stage| by_plan(stage, Simulate::Needed)),
        method("all effects", |stage| by_plan(stage, Simulate::All)),
        method("by hand", by_hand),
    ])
}

fn by_plan(stage: &Stage, simulate: Simulate) -> Film {
    let settings = settings();
    let camera = stage.camera.with_film(settings.width, settings.height);
    let plan = Plan::new(&stage.calls, SKILLS, simulate);
    Picture { scene: &stage.scene, camera }.draw::<Blinn, Off>(&settings, &plan).film
}

// ANCHOR: by_hand
/// A loop for scenes that have lamps, plain colours and no smooth mesh.
fn lit_by_hand(stage: &Stage) -> Film {
    let (settings, scene) = (settings(), &stage.scene);
    let camera = stage.camera.with_film(settings.width, settings.height);
    let rendering = render(&settings, |pixel, sampler| {
        let ray = camera.ray(pixel.position(sampler));
        let Some(nearest) = scene.nearest(&ray, &mut Off) else { return scene.background };
        let (hit, toward_eye) = (&nearest.hit, -ray.direction);
        let normal = facing(hit.geometric, toward_eye);
        let surface = nearest.object.material.at::<false>(hit.uv);
        let mut radiance = scene.ambient * surface.ambient;
        for arriving in scene.lights.iter().filter_map(|light| light.at(hit.point)) {
            radiance += Blinn::returned(&surface, normal, toward_eye, &arriving);
        }
        radiance
    });
    rendering.film
}
// ANCHOR_END: by_hand

/// A loop for scenes without light.
fn dark_by_hand(stage: &Stage) -> Film {
    let (settings, scene) = (settings(), &stage.scene);
    let camera = stage.camera.with_film(settings.width, settings.height);
    let rendering = render(&settings, |pixel, sampler| {
        let ray = camera.ray(pixel.position(sampler));
        scene.nearest(&ray, &mut Off).map_or(scene.background, |_| Color::ZERO)
    });
    rendering.film
}

/// A loop for scenes of nothing.
fn empty_by_hand(stage: &Stage) -> Film {
    render(&settings(), |_, _| stage.scene.background).film
}

fn note(table: &Table) -> String {
    let time = |label: &str| {
        let row = table.rows.iter().find(|row| row.label == label);
        row.map_or(f64::NAN, Row::nanoseconds)
    };
    let ratio = |scene: &str, way: &str| {
        time(&format!("{scene}, as called for")) / time(&format!("{scene}, {way}"))
    };
    let scenes = ["low-lamp", "dark", "empty"];
    let part = |way: &str| scenes.map(|scene| format!("{:.2}", ratio(scene, way))).join(", ");
    format!(
        "As called for, the three scenes take {} of the time of all effects, and {} of that of the \
         loops made for them.",
        part("all effects"),
        part("by hand"),
    )
}
