//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use light_sampling::by_light::{ByLight, LIGHT_SAMPLES};
use light_sampling::lights::Lights;
use microfacets::command::SKILLS;
use microfacets::finish::{Finish, Narrowest};
use microfacets::knobs::Roughness;
use path_tracing::bsdf::Bsdf;
use path_tracing::shot::Shot;
use path_tracing::stage::Stage;
use path_tracing::strategy::{ByDirection, Lighting};
use path_tracing::tracer::{
    BOUNCES, LAMPS_MET, LONGEST_PATH, SKY_SEEN, SPECULAR_BOUNCES, TRUNCATED_PATHS,
};
use path_tracing::world::World;
use ray_casting::camera::CAMERA_RAYS;
use russian_roulette::knobs::Threshold;
use russian_roulette::roulette::Roulette;
use shadows::visibility::{BLOCKED_RAYS, SHADOW_RAYS};
use triangles::brute::TRIANGLE_TESTS;

use crate::combined::Combined;
use crate::cost;
use crate::half::{Half, Side};
use crate::hard;
use crate::knobs::{Knobs, LightingChoice};
use crate::reuse::{REUSED_PATHS, Reuse};
use crate::scenes::{self, SCENES};

/// Chapter 16's program.
pub struct MultipleImportance;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<MultipleImportance>();

/// The work that is counted: chapter 13's, and the paths that are shared.
pub const EVENTS: &[Event] = &[
    CAMERA_RAYS,
    BOUNCES,
    SPECULAR_BOUNCES,
    REUSED_PATHS,
    LIGHT_SAMPLES,
    SHADOW_RAYS,
    BLOCKED_RAYS,
    LAMPS_MET,
    SKY_SEEN,
    TRUNCATED_PATHS,
    LONGEST_PATH,
    TRIANGLE_TESTS,
];

impl Chapter for MultipleImportance {
    const ID: &'static str = "16-multiple-importance";
    const ABOUT: &'static str =
        "Chapter 16: several ways to look for light, and the weights that let them share";
    const DEFAULTS: Defaults = Defaults { scene: "plates", width: 384, height: 256, spp: 16 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = EVENTS;

    type Knobs = Knobs;
    type Scene = Stage<Finish>;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage<Finish>, Failure> {
        let mut model = scenes::named(name, knobs.albedo.0)?;
        knobs.aim.apply(&mut model.view);
        if let Some(Roughness(alpha)) = knobs.roughness {
            model = model.map(|finish| finish.with_facets(|facets| facets.ggx.alpha = alpha));
        }
        Stage::new(&model).map_err(|error| Failure::Usage(error.to_string()))
    }

    fn warnings(stage: &Stage<Finish>) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage<Finish>, _knobs: &Knobs) -> Vec<Call> {
        stage.calls.clone()
    }

    fn draw<T: Tally>(
        stage: &Stage<Finish>,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let picture = Picture { stage, plan, settings, knobs };
        match Narrowest::new(stage.world(), plan) {
            Narrowest::Matte(world) => picture.of(&world),
            Narrowest::Smooth(world) => picture.of(&world),
            Narrowest::Finish(world) => picture.of(&world),
        }
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }
}

/// A picture that was asked for.
struct Picture<'a> {
    stage: &'a Stage<Finish>,
    plan: &'a Plan,
    settings: &'a Settings,
    knobs: &'a Knobs,
}

impl Picture<'_> {
    // ANCHOR: lit
    /// The picture of any materials, with light looked for as the options say: not at all where
    /// nothing glows.
    fn of<B: Bsdf, T: Tally>(&self, world: &World<B>) -> Rendering<T> {
        let Knobs { lighting, heuristic, way, lamps, .. } = *self.knobs;
        if !self.plan.simulates(Effect::AreaLights) {
            return self.lit(world, ByDirection);
        }
        let lights = Lights::new(world.space, &world.surfaces, lamps.into(), way.into());
        let combined = Combined { lights: &lights, heuristic: heuristic.into() };
        match lighting {
            LightingChoice::Combined => self.lit(world, combined),
            LightingChoice::LightHalf => self.lit(world, Half { combined, side: Side::Light }),
            LightingChoice::DirectionHalf => {
                self.lit(world, Half { combined, side: Side::Direction })
            }
            LightingChoice::Light => self.lit(world, ByLight { lights: &lights }),
            LightingChoice::Direction => self.lit(world, ByDirection),
        }
    }
    // ANCHOR_END: lit

    fn lit<B: Bsdf, L: Lighting + Copy, T: Tally>(
        &self,
        world: &World<B>,
        lighting: L,
    ) -> Rendering<T> {
        let Knobs { threshold: Threshold(threshold), depth, reuse, division, .. } = *self.knobs;
        let camera = &self.stage.camera;
        let shot = Shot { camera, lighting, ending: Roulette { threshold }, depth };
        let reuse = Reuse { side: reuse.side(), division: division.into() };
        shot.exposed(&reuse, world, self.plan, self.settings)
    }
}
