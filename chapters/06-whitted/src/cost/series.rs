//! How far to follow between two facing mirrors, where the right answer is known.

use std::hint::black_box;
use std::rc::Rc;

use blinn_phong::scene::Scene;
use common::cost::{Experiment, Method, Plot, no_note};
use common::tally::Off;
use ray_casting::ray::Ray;

use super::{rays, root_mean_square};
use crate::limits::Limits;
use crate::material::Mirrored;
use crate::scenes::Stage;
use crate::scenes::shows::FACING;
use crate::world::World;

/// The scene and the rays that are sent into it.
struct Mirrors {
    scene: Scene<Mirrored>,
    rays: Vec<Ray>,
}

/// None if the scene could not be built, which a test of the scenes would tell.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let stage = Stage::named("facing-mirrors", blinn_phong::scenes::brute_force, |_| ()).ok()?;
    let rays = rays(&stage.camera, 16, 12);
    let mirrors = Rc::new(Mirrors { scene: stage.scene, rays });
    let depths = [2, 8, 32, 128].map(|depth| {
        method(format!("depth {depth}"), "depth", &mirrors, Limits { depth, cutoff: 0.0 })
    });
    let cutoffs = [0.1, 0.01, 0.001].map(|cutoff| {
        let limits = Limits { depth: u32::MAX, cutoff };
        method(format!("cut-off {cutoff}"), "cut-off", &mirrors, limits)
    });
    Some(Experiment {
        name: "series",
        title: "Two facing mirrors that return 0.95, 0.9 and 0.8: how far to follow",
        work_unit: "camera rays",
        error_metric: "RMS relative error of the radiance against the whole series, to infinity",
        plot: Plot::ErrorOverTime("error of the radiance (RMS, relative)"),
        methods: depths.into_iter().chain(cutoffs).collect(),
        note: no_note,
    })
}

fn method(
    label: String,
    series: &'static str,
    mirrors: &Rc<Mirrors>,
    limits: Limits,
) -> Method<'static> {
    let [light, mirror] = FACING.map(|color| color.as_dvec3());
    let exact = light / (1.0 - mirror);
    let follow = move |mirrors: &Mirrors, ray: &Ray| {
        let world = World::<true, false, false, true> { scene: &mirrors.scene };
        limits.trace(&world, *ray, &mut Off)
    };
    let error = |ray: &Ray| (follow(mirrors, ray).as_dvec3() - exact) / exact;
    let errors = mirrors.rays.iter().flat_map(|ray| error(ray).to_array());
    let error = root_mean_square(errors);
    let mirrors = mirrors.clone();
    Method {
        label,
        series,
        size: 1.0,
        work: mirrors.rays.len() as u64,
        error,
        run: Box::new(move || {
            for ray in &mirrors.rays {
                black_box(follow(&mirrors, black_box(ray)));
            }
        }),
    }
}
