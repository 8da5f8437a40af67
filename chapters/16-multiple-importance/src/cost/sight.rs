//! A scene, and what it really looks like.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::Method;
use common::film::Film;
use common::plan::{Plan, Simulate};
use common::render::Settings;
use common::stats::error::film_relative_mse;
use common::tally::Off;
use light_sampling::by_light::ByLight;
use light_sampling::lamp::Way;
use light_sampling::lights::{Choice, Lights};
use microfacets::command::SKILLS;
use microfacets::finish::Finish;
use path_tracing::model::Model;
use path_tracing::shot::Shot;
use path_tracing::stage::Stage;
use path_tracing::strategy::{ByDirection, Ending, Lighting, Never};
use russian_roulette::roulette::Roulette;

use crate::combined::Combined;
use crate::heuristic::Heuristic;
use crate::reuse::{Division, Reuse};

/// A scene, and a converged picture of it.
pub(super) struct Sight {
    stage: Stage<Finish>,
    by_area: Lights,
    lights: Lights,
    width: u32,
    height: u32,
    depth: u32,
    truth: Film,
    /// How far the converged picture itself is off.
    own_error: f64,
}

/// How a picture is made.
#[derive(Clone, Copy, Debug)]
pub(super) struct How {
    pub(super) lighting: Look,
    pub(super) roulette: bool,
    /// Pixels along a side of the squares that share their paths.
    pub(super) side: u32,
    pub(super) spp: u32,
    pub(super) seed: u64,
}

/// How light is looked for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Look {
    Direction,
    Area,
    Light,
    Combined(Heuristic),
}

impl Sight {
    /// The scene, and the mean of two pictures of `spp` samples. None if the scene could not be
    /// built, which a test of the scenes would tell.
    pub(super) fn new(
        model: &Model<Finish>,
        [width, height]: [u32; 2],
        depth: u32,
        spp: u32,
    ) -> Option<Rc<Self>> {
        let stage = Stage::new(model).ok()?;
        let lights = |way| Lights::new(&stage.space, &stage.surfaces, Choice::Power, way);
        let (by_area, lights) = (lights(Way::Area), lights(Way::SolidAngle));
        let (truth, own_error) = (Film::new(width, height), 0.0);
        let mut sight = Self { stage, by_area, lights, width, height, depth, truth, own_error };
        let lighting = Look::Combined(Heuristic::Balance);
        let [mut one, other] =
            [2, 3].map(|seed| sight.draw(How { lighting, roulette: false, side: 1, spp, seed }));
        // Two pictures with the same error e differ by e √2, and their mean is off by e / √2.
        sight.own_error = film_relative_mse(&one, &other)?.sqrt() / 2.0;
        for (pixel, other) in one.pixels.iter_mut().zip(&other.pixels) {
            *pixel = (*pixel + *other) / 2.0;
        }
        sight.truth = one;
        Some(Rc::new(sight))
    }

    pub(super) fn draw(&self, how: How) -> Film {
        match how.lighting {
            Look::Direction => self.lit(ByDirection, how),
            Look::Area => self.lit(ByLight { lights: &self.by_area }, how),
            Look::Light => self.lit(ByLight { lights: &self.lights }, how),
            Look::Combined(heuristic) => {
                self.lit(Combined { lights: &self.lights, heuristic }, how)
            }
        }
    }

    fn lit<L: Lighting + Copy>(&self, lighting: L, how: How) -> Film {
        if how.roulette {
            self.ended(lighting, Roulette::default(), how)
        } else {
            self.ended(lighting, Never, how)
        }
    }

    fn ended<L: Lighting + Copy, E: Ending + Copy>(
        &self,
        lighting: L,
        ending: E,
        how: How,
    ) -> Film {
        let shot = Shot { camera: &self.stage.camera, lighting, ending, depth: self.depth };
        let plan = Plan::new(&self.stage.calls, SKILLS, Simulate::Needed);
        let How { side, spp, seed, .. } = how;
        let &Self { width, height, .. } = self;
        let settings = Settings { width, height, spp, seed, threads: 1, ..Settings::default() };
        let reuse = Reuse { side, division: Division::Balance };
        shot.exposed::<_, Off>(&reuse, &self.stage.world(), &plan, &settings).film
    }

    /// A method of an experiment: its error is that of one picture.
    pub(super) fn method(
        self: &Rc<Self>,
        series: &'static str,
        label: String,
        how: How,
    ) -> Method<'static> {
        let sight = Rc::clone(self);
        let error = film_relative_mse(&self.truth, &self.draw(how)).unwrap_or(f64::NAN);
        Method {
            label,
            series,
            size: f64::from(how.spp),
            work: u64::from(how.spp) * u64::from(self.width) * u64::from(self.height),
            error: error.sqrt(),
            run: Box::new(move || drop(black_box(sight.draw(how)))),
        }
    }
}

#[cfg(test)]
pub(super) fn assert_converged(sight: &Sight, most: f64) {
    assert!(sight.own_error < most, "{}", sight.own_error);
}
