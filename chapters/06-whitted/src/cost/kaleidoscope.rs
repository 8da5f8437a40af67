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
struct Tube {
    scene: Scene<Mirrored>,
    rays: Vec<Ray>,
    exact: Vec<Color>,
}

/// Further than any of these rays goes before it leaves the tube; what is left of the error is the
/// last rounding to `f32`.
const FAR: Limits = Limits { depth: 200, cutoff: 0.0 };

/// None if the scene could not be built, which a test of the scenes would tell.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let stage = Stage::named("kaleidoscope", blinn_phong::scenes::brute_force, |_| ()).ok()?;
    let rays = rays(&stage.camera, 16, 12);
    let mut tube = Tube { scene: stage.scene, rays, exact: Vec::new() };
    tube.exact = tube.rays.iter().map(|ray| follow(&tube, ray, FAR)).collect();
    let tube = Rc::new(tube);
    let depths = [2, 4, 8, 16].map(|depth| {
        method(format!("depth {depth}"), "depth", &tube, Limits { depth, cutoff: 0.0 })
    });
    let cutoffs = [0.8, 0.4, 0.01].map(|cutoff| {
        let limits = Limits { depth: u32::MAX, cutoff };
        method(format!("cut-off {cutoff}"), "cut-off", &tube, limits)
    });
    Some(Experiment {
        name: "kaleidoscope",
        title: "The kaleidoscope: all rays as deep, or each as long as it counts",
        work_unit: "camera rays",
        error_metric: "RMS error of the radiance against depth 200",
        plot: Plot::ErrorOverTime("error of the radiance (RMS)"),
        methods: depths.into_iter().chain(cutoffs).collect(),
        note: no_note,
    })
}

fn follow(tube: &Tube, ray: &Ray, limits: Limits) -> Color {
    let world = World::<true, true, true, true> { scene: &tube.scene };
    limits.trace(&world, *ray, &mut Off)
}

fn method(label: String, series: &'static str, tube: &Rc<Tube>, limits: Limits) -> Method<'static> {
    let pairs = tube.rays.iter().zip(&tube.exact);
    let errors = pairs.flat_map(|(ray, exact)| {
        (follow(tube, ray, limits).as_dvec3() - exact.as_dvec3()).to_array()
    });
    let error = root_mean_square(errors);
    let tube = tube.clone();
    Method {
        label,
        series,
        size: 1.0,
        work: tube.rays.len() as u64,
        error,
        run: Box::new(move || {
            for ray in &tube.rays {
                black_box(follow(&tube, black_box(ray), limits));
            }
        }),
    }
}
