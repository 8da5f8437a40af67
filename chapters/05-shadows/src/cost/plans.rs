//! What the plan saves: a scene with the effects it calls for, with all, and by a loop that was
//! written for it alone.

use std::hint::black_box;
use std::sync::Arc;

use blinn_phong::models::{Blinn, Model};
use blinn_phong::scenes::{Stage, brute_force};
use blinn_phong::shading::facing;
use common::chapter::Failure;
use common::cost::{Experiment, Method, Plot, Row, Table};
use common::film::Film;
use common::plan::{Plan, Simulate};
use common::render::{Settings, render};
use common::stats::error::film_rmse;
use common::tally::Off;

use crate::calls;
use crate::command::SKILLS;
use crate::lighting::from_lamps;
use crate::offset::Offset;
use crate::picture::Picture;
use crate::scenes::named;

/// One thread, so that the median is of the loop and not of who else was running.
fn settings(height: u32) -> Settings {
    Settings { width: 4 * height / 3, height, threads: 1, ..Settings::default() }
}

pub(super) fn experiment() -> Result<Experiment<'static>, Failure> {
    let mut methods = scene("three-lamps", 36, by_hand::<true>)?;
    methods.extend(scene("alone", 240, by_hand::<false>)?);
    Ok(Experiment {
        name: "plans",
        title: "What the plan saves: a scene's own effects, all effects, and a loop made for the scene",
        work_unit: "pixels",
        error_metric: "RMS difference of the picture from that with all effects",
        plot: Plot::TimeOver("effects simulated"),
        methods,
        note,
    })
}

/// A way to draw a scene.
type Draw = fn(&Stage, &Settings) -> Film;

/// The three ways to draw a scene.
fn scene(name: &'static str, height: u32, by_hand: Draw) -> Result<Vec<Method<'static>>, Failure> {
    let stage = Arc::new(named(name, brute_force)?);
    let settings = settings(height);
    let reference = by_plan(&stage, &settings, Simulate::All);
    let effects = |simulate| plan(&stage, simulate).simulated.len();
    let sizes = [effects(Simulate::Needed), effects(Simulate::All)];
    let needed = |stage: &Stage, settings: &Settings| by_plan(stage, settings, Simulate::Needed);
    let all = |stage: &Stage, settings: &Settings| by_plan(stage, settings, Simulate::All);
    let ways: [(&str, usize, Draw); 3] = [
        ("as called for", sizes[0], needed),
        ("all effects", sizes[1], all),
        ("by hand", sizes[0], by_hand),
    ];
    let method = |(way, effects, draw): (&str, usize, Draw)| {
        let (stage, settings) = (stage.clone(), settings.clone());
        Method {
            label: format!("{name}, {way}"),
            series: name,
            size: effects as f64,
            work: u64::from(settings.width) * u64::from(settings.height),
            error: film_rmse(&reference, &draw(&stage, &settings)).unwrap_or(f64::NAN),
            run: Box::new(move || {
                black_box(draw(&stage, &settings));
            }) as Box<dyn FnMut()>,
        }
    };
    Ok(ways.map(method).into())
}

fn plan(stage: &Stage, simulate: Simulate) -> Plan {
    Plan::new(&calls::of_scene(&stage.scene, &stage.calls), SKILLS, simulate)
}

fn by_plan(stage: &Stage, settings: &Settings, simulate: Simulate) -> Film {
    let camera = stage.camera.with_film(settings.width, settings.height);
    let picture = Picture { scene: &stage.scene, camera, offset: Offset::Bound };
    picture.draw::<Off>(settings, &plan(stage, simulate)).film
}

// ANCHOR: by_hand
/// A loop for plain colours and flat meshes, with shadows or without.
fn by_hand<const SHADOWS: bool>(stage: &Stage, settings: &Settings) -> Film {
    let scene = &stage.scene;
    let camera = stage.camera.with_film(settings.width, settings.height);
    let rendering = render(settings, |pixel, sampler| {
        let ray = camera.ray(pixel.position(sampler));
        let Some(nearest) = scene.nearest(&ray, &mut Off) else { return scene.background };
        let (hit, toward_eye) = (&nearest.hit, -ray.direction);
        let normal = facing(hit.geometric, toward_eye);
        let surface = nearest.object.material.at::<false>(hit.uv);
        let returned = |arriving: &_| Blinn::returned(&surface, normal, toward_eye, arriving);
        let lights = &scene.lights;
        scene.ambient * surface.ambient
            + from_lamps::<SHADOWS, _>(scene, lights, hit, toward_eye, &mut Off, returned)
    });
    rendering.film
}
// ANCHOR_END: by_hand

fn note(table: &Table) -> String {
    let time = |label: &str| {
        table.rows.iter().find(|row| row.label == label).map_or(f64::NAN, Row::nanoseconds)
    };
    let ratio = |way: &str| time(&format!("alone, {way}")) / time("alone, as called for");
    format!(
        "The ball alone with all effects takes {:.2} of the time with those it calls for, and by hand {:.2}.",
        ratio("all effects"),
        ratio("by hand")
    )
}
