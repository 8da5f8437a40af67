//! Depth against cut-off in a scene where some mirrors return nearly all and some hardly anything.

use std::hint::black_box;
use std::rc::Rc;

use blinn_phong::scene::Scene;
use common::cost::{Experiment, Method, Plot, no_note};
use common::film::Color;
use common::tally::Off;
use ray_casting::ray::Ray;

use super::{rays, root_mean_square};
use crate::limits::Limits;
use crate::material::Mirrored;
use crate::scenes::Stage;
use crate::world::World;

/// The scene, the rays that are sent into it, and what they bring.
struct Hall {
    scene: Scene<Mirrored>,
    rays: Vec<Ray>,
    exact: Vec<Color>,
}

/// So far that what is left of any light, 0.94²⁰⁰ of it, is below a part in 10⁵ of the error of
/// every row.
const FAR: Limits = Limits { depth: 200, cutoff: 0.0 };

/// None if the scene could not be built, which a test of the scenes would tell.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let stage = Stage::named("hall", blinn_phong::scenes::brute_force, |_| ()).ok()?;
    let rays = rays(&stage.camera, 40, 30);
    let mut hall = Hall { scene: stage.scene, rays, exact: Vec::new() };
    hall.exact = hall.rays.iter().map(|ray| follow(&hall, ray, FAR)).collect();
    let hall = Rc::new(hall);
    let depths = [0, 1, 2, 3, 4, 6, 8].map(|depth| {
        method(format!("depth {depth}"), "depth", &hall, Limits { depth, cutoff: 0.0 })
    });
    let cutoffs = [0.9, 0.8, 0.7, 0.5, 0.3, 0.1, 0.05].map(|cutoff| {
        let limits = Limits { depth: u32::MAX, cutoff };
        method(format!("cut-off {cutoff}"), "cut-off", &hall, limits)
    });
    Some(Experiment {
        name: "hall",
        title: "A hall of mirrors: following all rays as deep, or those that count as long as they do",
        work_unit: "camera rays",
        error_metric: "RMS error of the radiance against depth 200",
        plot: Plot::ErrorOverTime("error of the radiance (RMS)"),
        methods: depths.into_iter().chain(cutoffs).collect(),
        note: no_note,
    })
}

fn follow(hall: &Hall, ray: &Ray, limits: Limits) -> Color {
    let world = World::<true, true, true, true> { scene: &hall.scene };
    limits.trace(&world, *ray, &mut Off)
}

fn method(label: String, series: &'static str, hall: &Rc<Hall>, limits: Limits) -> Method<'static> {
    let pairs = hall.rays.iter().zip(&hall.exact);
    let errors = pairs.flat_map(|(ray, exact)| {
        (follow(hall, ray, limits).as_dvec3() - exact.as_dvec3()).to_array()
    });
    let error = root_mean_square(errors);
    let hall = hall.clone();
    Method {
        label,
        series,
        size: 1.0,
        work: hall.rays.len() as u64,
        error,
        run: Box::new(move || {
            for ray in &hall.rays {
                black_box(follow(&hall, black_box(ray), limits));
            }
        }),
    }
}
