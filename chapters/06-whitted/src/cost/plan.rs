//! What the plan saves: a scene without mirrors, drawn with what it calls for and with everything.

use std::hint::black_box;
use std::rc::Rc;

use blinn_phong::scene::Scene;
use common::cost::{Experiment, Method, Plot, Row, Table};
use common::film::Color;
use common::tally::Off;
use ray_casting::ray::Ray;

use super::{rays, root_mean_square};
use crate::limits::Limits;
use crate::material::Mirrored;
use crate::scatter::Scatter;
use crate::scenes::Stage;
use crate::world::{World, local};

/// The scene and the rays that are sent into it.
struct Balls {
    scene: Scene<Mirrored>,
    rays: Vec<Ray>,
}

const REPEATS: usize = 10;

/// None if the scene could not be built, which a test of the scenes would tell.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let stage = Stage::named("two-lamps", blinn_phong::scenes::brute_force, |_| ()).ok()?;
    let rays = rays(&stage.camera, 64, 48);
    let balls = Rc::new(Balls { scene: stage.scene, rays });
    Some(Experiment {
        name: "plan",
        title: "A scene without mirrors: what is not called for costs nothing",
        work_unit: "camera rays",
        error_metric: "RMS difference from the loop by hand",
        plot: Plot::ErrorOverTime("difference (RMS)"),
        methods: vec![
            method("by hand", &balls, by_hand),
            method("needed", &balls, needed),
            method("all", &balls, all),
        ],
        note,
    })
}

/// A loop that was never written for mirrors: lamps, shadows and paints, nothing else.
fn by_hand(scene: &Scene<Mirrored>, ray: &Ray) -> Color {
    match scene.nearest(ray, &mut Off) {
        Some(found) => {
            let surface = &found.object.material.surface;
            local::<true, true, Off>(scene, surface, &found.hit, -ray.direction, &mut Off)
        }
        None => scene.background,
    }
}

fn needed(scene: &Scene<Mirrored>, ray: &Ray) -> Color {
    World::<true, true, true, false> { scene }.scatter(ray, &mut Off).light
}

fn all(scene: &Scene<Mirrored>, ray: &Ray) -> Color {
    let limits = Limits { depth: 5, cutoff: 0.001 };
    limits.trace(&World::<true, true, true, true> { scene }, *ray, &mut Off)
}

fn method(
    label: &'static str,
    balls: &Rc<Balls>,
    radiance: fn(&Scene<Mirrored>, &Ray) -> Color,
) -> Method<'static> {
    let Balls { scene, rays } = &**balls;
    let difference = |ray: &Ray| (radiance(scene, ray) - by_hand(scene, ray)).as_dvec3();
    let error = root_mean_square(rays.iter().flat_map(|ray| difference(ray).to_array()));
    let balls = balls.clone();
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: (REPEATS * balls.rays.len()) as u64,
        error,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                for ray in &balls.rays {
                    black_box(radiance(&balls.scene, black_box(ray)));
                }
            }
        }),
    }
}

fn note(table: &Table) -> String {
    let [by_hand, needed, all] = &table.rows[..] else { return String::new() };
    let more = |row: &Row| common::cost::change(row.nanoseconds() / by_hand.nanoseconds());
    format!(
        "Against the loop by hand, what is needed takes {} time, and all takes {}.",
        more(needed),
        more(all)
    )
}
