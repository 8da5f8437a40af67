//! What the plan saves: the matte box with what it calls for, and with all.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, Row, Table};
use common::film::Film;
use common::plan::{Plan, Simulate};
use common::render::Settings;
use common::stats::error::film_rmse;
use common::tally::Off;
use path_tracing::command::SKILLS;
use path_tracing::shot::Shot;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::strategy::Never;

use crate::by_light::ByLight;
use crate::lamp::Way;
use crate::lights::{Choice, Lights};
use crate::scenes::named;

/// None if the scene can't be built, which a test of the scenes would tell.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let stage = Rc::new(Stage::new(&named("cornell", 0.5).ok()?).ok()?);
    let needed = draw(&stage, Simulate::Needed);
    let method = |label: &'static str, simulate| {
        let stage = Rc::clone(&stage);
        Method {
            label: label.into(),
            series: label,
            size: 1.0,
            work: 1,
            error: film_rmse(&needed, &draw(&stage, simulate)).unwrap_or(f64::NAN),
            run: Box::new(move || drop(black_box(draw(&stage, simulate)))),
        }
    };
    let methods = vec![method("needed", Simulate::Needed), method("all", Simulate::All)];
    Some(Experiment {
        name: "plan",
        title: "The Cornell box, 64x64, 16 samples: what is not called for costs nothing",
        work_unit: "pictures",
        error_metric: "RMSE against what is needed",
        plot: Plot::ErrorOverTime("difference (RMSE)"),
        methods,
        note,
    })
}

fn draw(stage: &Stage<Smooth>, simulate: Simulate) -> Film {
    let lights = Lights::new(&stage.space, &stage.surfaces, Choice::Power, Way::Area);
    let lighting = ByLight { lights: &lights };
    let shot = Shot { camera: &stage.camera, lighting, ending: Never, depth: 8 };
    let plan = Plan::new(&stage.calls, SKILLS, simulate);
    let settings = Settings { width: 64, height: 64, spp: 16, ..Settings::default() };
    let world = stage.world();
    match world.narrowed(Smooth::lambert) {
        Some(matte) if simulate == Simulate::Needed => {
            shot.draw::<_, Off>(&matte, &plan, &settings).film
        }
        _ => shot.draw::<_, Off>(&world, &plan, &settings).film,
    }
}

fn note(table: &Table) -> String {
    let [needed, all] = &table.rows[..] else { return String::new() };
    let ratio = |of: fn(&Row) -> f64| common::cost::change(of(all) / of(needed));
    format!(
        "With a sky, mirrors and glass that aren't there it takes {} time.",
        ratio(Row::nanoseconds)
    )
}
