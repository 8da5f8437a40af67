//! The Cornell box, small, with its light sampled.

use common::film::Film;
use common::render::{Settings, render_counted};
use common::tally::{Off, Tally};
use light_sampling::by_light::ByLight;
use light_sampling::lamp::Way;
use light_sampling::lights::{Choice, Lights};
use light_sampling::scenes;
use path_tracing::lambert::Lambert;
use path_tracing::shot::position;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::tracer::PathTracer;
use path_tracing::world::World;

use crate::abreast::{Abreast, Start};
use crate::ending::Rule;

/// Pixels on each side of the picture.
const SIDE: u32 = 24;

/// How a picture is made.
#[derive(Clone, Copy)]
pub(super) struct How {
    pub(super) rule: Rule,
    pub(super) depth: u32,
    pub(super) spp: u32,
    pub(super) seed: u64,
}

/// The box.
pub(super) struct Sight {
    stage: Stage<Smooth>,
}

impl Sight {
    /// None if the scene could not be built, which a test of the scenes would tell.
    pub(super) fn new() -> Option<Self> {
        let model = scenes::named("cornell", 0.5).ok()?;
        Some(Self { stage: Stage::new(&model).ok()? })
    }

    /// The picture, drawn by one thread: the time is that of the paths and not of who else ran.
    pub(super) fn draw<T: Tally>(&self, how: How) -> (Film, T) {
        let world = self.stage.world();
        let Some(world): Option<World<Lambert>> = world.narrowed(Smooth::lambert) else {
            return (Film::new(SIDE, SIDE), T::default());
        };
        let lights = lights(&world);
        let How { rule: ending, depth, spp, seed } = how;
        let lighting = ByLight { lights: &lights };
        let tracer = PathTracer::<_, _, _, true, false> { world: &world, lighting, ending, depth };
        let camera = self.stage.camera.with_film(SIDE, SIDE);
        let rendering = render_counted(&settings(spp, seed), |pixel, sampler, tally: &mut T| {
            tracer.radiance(camera.ray(position(pixel, sampler)), sampler, tally)
        });
        (rendering.film, rendering.tally)
    }

    /// The same by sixteen paths side by side; black if that is not possible.
    pub(super) fn draw_abreast(&self, how: How, start: Start) -> Film {
        self.abreast(how, start).unwrap_or_else(|| Film::new(SIDE, SIDE))
    }

    fn abreast(&self, how: How, start: Start) -> Option<Film> {
        let world = self.stage.world().narrowed(Smooth::lambert)?;
        let (lights, settings) = (lights(&world), settings(how.spp, how.seed));
        let Rule::Throughput(roulette) = how.rule else { return None };
        let ending = (roulette, how.depth);
        let abreast = Abreast::new(&world, &self.stage.camera, &lights, ending, &settings)?;
        Some(abreast.starting(start).draw::<Off>().film)
    }
}

fn lights(world: &World<Lambert>) -> Lights {
    Lights::new(world.space, &world.surfaces, Choice::Power, Way::Area)
}

fn settings(spp: u32, seed: u64) -> Settings {
    Settings { width: SIDE, height: SIDE, spp, seed, threads: 1, ..Settings::default() }
}
