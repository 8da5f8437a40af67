//! What the plan saves: two boxes by what they need and by everything, one also by a loop for it alone.

use std::hint::black_box;
use std::rc::Rc;

use common::chapter::Chapter;
use common::cost::{Experiment, Method, Plot, Row, Table, change};
use common::film::Film;
use common::plan::{Plan, Simulate};
use common::render::{Rendering, Settings, render};
use common::stats::error::film_rmse;
use common::tally::Off;
use ray_casting::knobs::Aim;

use super::by_hand;
use crate::command::{PathTracing, SKILLS};
use crate::knobs::{Albedo, Knobs};
use crate::shot::position;
use crate::smooth::Smooth;
use crate::stage::Stage;

const DEPTH: u32 = 8;
const SIDE: u32 = 64;

/// The scene called `name`, as the program builds it.
fn sight(name: &str) -> Option<Rc<Stage<Smooth>>> {
    PathTracing::build(name, &knobs()).ok().map(Rc::new)
}

fn knobs() -> Knobs {
    Knobs { depth: DEPTH, albedo: Albedo(0.5), aim: Aim::default() }
}

fn settings() -> Settings {
    Settings { width: SIDE, height: SIDE, spp: 1, threads: 1, ..Settings::default() }
}

/// The picture as the program draws it.
fn planned(stage: &Stage<Smooth>, simulate: Simulate) -> Film {
    let plan = Plan::new(&PathTracing::calls(stage, &knobs()), SKILLS, simulate);
    let drawn: Rendering<Off> = PathTracing::draw(stage, &plan, &settings(), &knobs());
    drawn.film
}

fn needed(stage: &Stage<Smooth>) -> Film {
    planned(stage, Simulate::Needed)
}

fn all(stage: &Stage<Smooth>) -> Film {
    planned(stage, Simulate::All)
}

/// The picture of a matte scene with lamps alone, and black for any other.
fn by_hand(stage: &Stage<Smooth>) -> Film {
    let Some(world) = stage.world().narrowed(Smooth::lambert) else {
        return Film::new(SIDE, SIDE);
    };
    let camera = stage.camera.with_film(SIDE, SIDE);
    let shade = |pixel, sampler: &_| {
        by_hand::matte(&world, camera.ray(position(pixel, sampler)), DEPTH, sampler)
    };
    render(&settings(), shade).film
}

/// The box with its lamp on, and with it off.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let (lit, dark) = (sight("cornell")?, sight("dark")?);
    Some(Experiment {
        name: "plan",
        title: "The matte Cornell box, 64x64, and the same with its lamp off",
        work_unit: "pixels",
        error_metric: "RMS difference from the loop by hand",
        plot: Plot::ErrorOverTime("difference (RMS)"),
        methods: vec![
            method("lamp on, by hand", &lit, by_hand),
            method("lamp on, needed", &lit, needed),
            method("lamp on, all", &lit, all),
            method("lamp off, needed", &dark, needed),
            method("lamp off, all", &dark, all),
        ],
        note,
    })
}

fn method(
    label: &'static str,
    stage: &Rc<Stage<Smooth>>,
    draw: fn(&Stage<Smooth>) -> Film,
) -> Method<'static> {
    let error = film_rmse(&by_hand(stage), &draw(stage)).unwrap_or(f64::NAN);
    let stage = Rc::clone(stage);
    let run = Box::new(move || drop(black_box(draw(&stage))));
    let work = u64::from(SIDE * SIDE);
    Method { label: label.into(), series: label, size: 1.0, work, error, run }
}

fn note(table: &Table) -> String {
    let [hand, needed, all, dark_needed, dark_all] = &table.rows[..] else { return String::new() };
    let against = |row: &Row, base: &Row| row.nanoseconds() / base.nanoseconds();
    format!(
        "With the lamp on, what is needed takes {} time than the loop by hand, and all takes {} than \
         what is needed. With the lamp off, all takes {:.0} times as long as what is needed.",
        change(against(needed, hand)),
        change(against(all, needed)),
        against(dark_all, dark_needed)
    )
}
