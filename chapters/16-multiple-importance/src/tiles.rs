//! For tests: pictures as means over tiles, with their spread.

use common::film::Film;
use common::plan::{Plan, Simulate};
use common::render::Settings;
use common::stats::estimate::welch_test;
use common::stats::running::Running;
use common::tally::Off;
use microfacets::command::SKILLS;
use microfacets::finish::Finish;
use path_tracing::model::Model;
use path_tracing::shot::{ByPixel, Exposure, Shot};
use path_tracing::stage::Stage;
use path_tracing::strategy::{Lighting, Never};

/// Pixels along a side of a tile.
const TILE: u32 = 4;

/// How many pictures, and of what kind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Runs {
    pub width: u32,
    pub height: u32,
    pub spp: u32,
    pub count: u64,
    pub depth: u32,
    /// Another number, other pictures.
    pub seed: u64,
}

pub(crate) fn stage(model: &Model<Finish>) -> Stage<Finish> {
    Stage::new(model).expect("a scene that can be")
}

/// The brightness of each tile in as many pictures as `runs` says.
pub(crate) fn tiles<L: Lighting + Copy>(
    stage: &Stage<Finish>,
    lighting: L,
    runs: &Runs,
) -> Vec<Running> {
    exposed_tiles(stage, lighting, &ByPixel, runs)
}

/// The same, with the film exposed in another way.
pub(crate) fn exposed_tiles<L: Lighting + Copy>(
    stage: &Stage<Finish>,
    lighting: L,
    exposure: &impl Exposure,
    runs: &Runs,
) -> Vec<Running> {
    let shot = Shot { camera: &stage.camera, lighting, ending: Never, depth: runs.depth };
    let plan = Plan::new(&stage.calls, SKILLS, Simulate::All);
    let world = stage.world();
    let mut means = vec![Running::default(); (runs.width / TILE * (runs.height / TILE)) as usize];
    for number in 0..runs.count {
        let &Runs { width, height, spp, .. } = runs;
        let seed = 100_000 * runs.seed + number;
        let settings = Settings { width, height, spp, seed, ..Settings::default() };
        let film = shot.exposed::<_, Off>(exposure, &world, &plan, &settings).film;
        for (mean, sample) in means.iter_mut().zip(of_film(&film)) {
            mean.add(sample);
        }
    }
    means
}

fn of_film(film: &Film) -> Vec<f64> {
    let across = film.width / TILE;
    let tile = |index: u32| {
        let (left, top) = (index % across * TILE, index / across * TILE);
        let pixels = (0..TILE * TILE).map(|at| film.pixel(left + at % TILE, top + at / TILE));
        pixels.map(|pixel| f64::from(pixel.element_sum())).sum::<f64>() / f64::from(3 * TILE * TILE)
    };
    (0..across * (film.height / TILE)).map(tile).collect()
}

/// How often right code would show so large a difference in one of all tiles (Šidák).
pub(crate) fn least_p_value(one: &[Running], other: &[Running]) -> f64 {
    let p_value = |(one, other)| welch_test(one, other).map_or(1.0, |test| test.p_value);
    let least = one.iter().zip(other).map(p_value).fold(1.0, f64::min);
    1.0 - libm::exp(one.len() as f64 * libm::log1p(-least.min(1.0 - 1e-12)))
}
