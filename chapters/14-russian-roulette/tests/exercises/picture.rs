//! The Cornell box, drawn with a reader's roulette.

use common::film::{Color, Film};
use common::render::{Settings, render};
use common::tally::Off;
use light_sampling::by_light::ByLight;
use light_sampling::lamp::Way;
use light_sampling::lights::{Choice, Lights};
use light_sampling::scenes;
use path_tracing::random::Random;
use path_tracing::shot::position;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::strategy::{Ending, Never};
use path_tracing::tracer::PathTracer;
use russian_roulette::roulette::SURVIVAL;

/// How the box is drawn.
#[derive(Debug)]
pub(super) struct Picture {
    survival: f32,
    spp: u32,
}

pub(super) fn boxes() -> Vec<Picture> {
    vec![Picture { survival: 0.8, spp: 64 }, Picture { survival: 0.65, spp: 64 }]
}

/// A reader's roulette.
type GoOn = fn(f32, f32) -> Option<f32>;

/// The same as an ending.
struct Yours {
    go_on: GoOn,
    survival: f32,
}

impl Ending for Yours {
    fn factor(&self, _throughput: Color, _bounce: u32, random: &Random) -> Option<f32> {
        (self.go_on)(self.survival, random.number(SURVIVAL))
    }
}

impl Picture {
    /// All light, by paths that don't end by chance.
    pub(super) fn whole(&self) -> Film {
        self.film(Never)
    }

    pub(super) fn draw(&self, go_on: GoOn) -> Film {
        self.film(Yours { go_on, survival: self.survival })
    }

    fn film(&self, ending: impl Ending) -> Film {
        let model = scenes::named("cornell", 0.5).expect("a built-in scene");
        let stage = Stage::new(&model).expect("a good scene");
        let world = stage.world().narrowed(Smooth::lambert).expect("all is matte");
        let lights = Lights::new(world.space, &world.surfaces, Choice::Power, Way::Area);
        let (lighting, depth) = (ByLight { lights: &lights }, 30);
        let tracer = PathTracer::<_, _, _, true, false> { world: &world, lighting, ending, depth };
        let settings = Settings { width: 32, height: 32, spp: self.spp, ..Settings::default() };
        let camera = stage.camera.with_film(settings.width, settings.height);
        let rendering = render(&settings, |pixel, sampler| {
            tracer.radiance(camera.ray(position(pixel, sampler)), sampler, &mut Off)
        });
        rendering.film
    }
}

/// Whether two pictures have the same light, but for noise: in sixteen tiles, on average within 4 %.
pub(super) fn alike(expected: &Film, yours: &Film) -> bool {
    let tiles = expected.tile_means(4, 4).into_iter().zip(yours.tile_means(4, 4));
    let apart = tiles.map(|(expected, yours)| {
        let change = (yours - expected).element_sum() / expected.element_sum();
        f64::from(change * change)
    });
    let square = apart.sum::<f64>() / 16.0;
    square.sqrt() < 0.04
}
