//! What the plan saves: a matte scene by what it needs, by everything, and by a loop for it alone.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, Row, Table, change};
use common::film::Color;
use common::sampler::Sampler;
use common::stats::error::rmse;
use common::tally::Off;
use glam::Vec2;
use ray_casting::ray::Ray;

use super::by_hand;
use crate::bsdf::Bsdf;
use crate::lambert::Lambert;
use crate::scenes;
use crate::smooth::Smooth;
use crate::stage::Stage;
use crate::strategy::{ByDirection, Never};
use crate::tracer::PathTracer;
use crate::world::World;

const DEPTH: u32 = 8;
const SIDE: u32 = 64;

/// A scene and the rays that are sent into it.
struct Sight {
    stage: Stage<Smooth>,
    rays: Vec<Ray>,
}

impl Sight {
    fn new(name: &str) -> Option<Rc<Self>> {
        let stage = Stage::new(&scenes::named(name, 0.5).ok()?).ok()?;
        let camera = stage.camera.with_film(SIDE, SIDE);
        let pixels = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| Vec2::new(x as f32, y as f32)));
        let rays = pixels.map(|pixel| camera.ray(pixel + 0.5)).collect();
        Some(Rc::new(Self { stage, rays }))
    }

    fn matte(&self) -> Option<World<'_, Lambert>> {
        self.stage.world().narrowed(Smooth::lambert)
    }

    /// One sample of every pixel.
    fn draw(&self, radiance: impl Fn(Ray, &Sampler) -> Color) -> Vec<Color> {
        let pixels = (0..).zip(&self.rays);
        pixels.map(|(pixel, ray)| radiance(*ray, &Sampler::new(1, pixel, 0, 1))).collect()
    }

    fn follow<B: Bsdf, const EMITTERS: bool, const SKY: bool>(
        &self,
        world: &World<B>,
    ) -> Vec<Color> {
        let (lighting, ending, depth) = (ByDirection, Never, DEPTH);
        let tracer: PathTracer<_, _, _, EMITTERS, SKY> =
            PathTracer { world, lighting, ending, depth };
        self.draw(|ray, sampler| tracer.radiance(ray, sampler, &mut Off))
    }

    fn needed(&self) -> Vec<Color> {
        self.matte().map_or(Vec::new(), |world| self.follow::<_, true, false>(&world))
    }

    fn all(&self) -> Vec<Color> {
        self.follow::<_, true, true>(&self.stage.world())
    }

    fn by_hand(&self) -> Vec<Color> {
        self.matte().map_or(Vec::new(), |world| {
            self.draw(|ray, sampler| by_hand::matte(&world, ray, DEPTH, sampler))
        })
    }
}

/// The box by itself.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let sight = Sight::new("cornell")?;
    Some(Experiment {
        name: "plan",
        title: "The matte Cornell box, 64x64: what is not called for costs nothing",
        work_unit: "paths",
        error_metric: "RMS difference from the loop by hand",
        plot: Plot::ErrorOverTime("difference (RMS)"),
        methods: vec![
            method("by hand", &sight, Sight::by_hand),
            method("needed", &sight, Sight::needed),
            method("all", &sight, Sight::all),
        ],
        note,
    })
}

fn method(
    label: &'static str,
    sight: &Rc<Sight>,
    draw: fn(&Sight) -> Vec<Color>,
) -> Method<'static> {
    let channels = |colors: Vec<Color>| -> Vec<f64> {
        colors.iter().flat_map(|color| color.to_array().map(f64::from)).collect()
    };
    let error = rmse(&channels(sight.by_hand()), &channels(draw(sight))).unwrap_or(f64::NAN);
    let work = sight.rays.len() as u64;
    let sight = Rc::clone(sight);
    let run = Box::new(move || drop(black_box(draw(&sight))));
    Method { label: label.into(), series: label, size: 1.0, work, error, run }
}

fn note(table: &Table) -> String {
    let [hand, needed, all] = &table.rows[..] else { return String::new() };
    let against = |row: &Row, base: &Row| change(row.nanoseconds() / base.nanoseconds());
    format!(
        "What is needed takes {} time than the loop by hand; all takes {} than what is needed.",
        against(needed, hand),
        against(all, needed)
    )
}
