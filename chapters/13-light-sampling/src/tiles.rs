//! For tests: pictures as means over tiles, with their errors.

use common::film::Film;
use common::plan::{Plan, Simulate};
use common::render::Settings;
use common::stats::estimate::{Estimate, z_test};
use common::stats::running::Running;
use common::stats::sidak;
use common::tally::Off;
use path_tracing::command::SKILLS;
use path_tracing::shot::Shot;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::strategy::{Lighting, Never};

use crate::scenes::named;

/// Pixels along a side of a tile.
const TILE: u32 = 4;

/// How many pictures, and of what kind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Runs {
    pub(crate) side: u32,
    pub(crate) spp: u32,
    pub(crate) count: u64,
    pub(crate) depth: u32,
}

/// The mean of a tile in one colour, over pictures with a seed each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tile {
    estimate: Estimate,
}

impl Tile {
    pub(crate) fn mean(&self) -> f64 {
        self.estimate.mean
    }

    pub(crate) fn standard_error(&self) -> f64 {
        self.estimate.standard_error
    }

    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let Estimate { mean, standard_error } = self.estimate;
        Self { estimate: Estimate { mean: factor * mean, standard_error: factor * standard_error } }
    }
}

impl Runs {
    pub(crate) fn exact(value: f64) -> Tile {
        Tile { estimate: Estimate::exact(value) }
    }
}

pub(crate) fn stage(name: &str) -> Stage<Smooth> {
    Stage::new(&named(name, 0.5).expect("a scene")).expect("a scene that can be")
}

/// The tiles of as many pictures as `runs` says.
pub(crate) fn tiles<L: Lighting + Copy>(
    stage: &Stage<Smooth>,
    lighting: L,
    runs: &Runs,
) -> Vec<Tile> {
    let shot = Shot { camera: &stage.camera, lighting, ending: Never, depth: runs.depth };
    let plan = Plan::new(&stage.calls, SKILLS, Simulate::All);
    let world = stage.world();
    let across = runs.side / TILE;
    let mut means = vec![Running::default(); (3 * across * across) as usize];
    for seed in 0..runs.count {
        let seed = 1000 * u64::from(runs.spp) + 10 * runs.count + 100_000 * seed;
        let settings = Settings {
            width: runs.side,
            height: runs.side,
            spp: runs.spp,
            seed,
            ..Settings::default()
        };
        let film = shot.draw::<_, Off>(&world, &plan, &settings).film;
        for (mean, sample) in means.iter_mut().zip(of_film(&film)) {
            mean.add(sample);
        }
    }
    means.iter().map(|mean| Tile { estimate: estimate(mean) }).collect()
}

fn estimate(mean: &Running) -> Estimate {
    Estimate::of(mean).unwrap_or(Estimate::exact(mean.mean()))
}

fn of_film(film: &Film) -> Vec<f64> {
    let across = film.width / TILE;
    let tile = |index: u32, channel: usize| {
        let (left, top) = (index % across * TILE, index / across * TILE);
        let pixels = (0..TILE * TILE).map(|at| film.pixel(left + at % TILE, top + at / TILE));
        pixels.map(|pixel| f64::from(pixel[channel])).sum::<f64>() / f64::from(TILE * TILE)
    };
    (0..across * across).flat_map(|index| (0..3).map(move |channel| tile(index, channel))).collect()
}

/// How often right code would show so large a difference in one of all tiles (Šidák).
pub(crate) fn least_p_value(one: &[Tile], other: &[Tile]) -> f64 {
    let p_values =
        one.iter().zip(other).map(|(one, other)| z_test(&one.estimate, &other.estimate).p_value);
    let least = p_values.fold(1.0, f64::min);
    // The significance at which one test of so many would have just this one.
    1.0 - libm::exp(one.len() as f64 * libm::log1p(-least.min(1.0 - 1e-12)))
}

#[test]
fn one_in_a_hundred_of_forty_eight_is_not_rare() {
    let exact = vec![Runs::exact(1.0); 48];
    let mut other = exact.clone();
    other[7].estimate = Estimate { mean: 1.0 + 2.58, standard_error: 1.0 };
    assert!(least_p_value(&exact, &other) > 0.3, "{}", sidak(0.01, 48));
}
