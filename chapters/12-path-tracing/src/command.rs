//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use ray_casting::camera::CAMERA_RAYS;
use triangles::brute::TRIANGLE_TESTS;

use crate::knobs::Knobs;
use crate::scenes::{self, SCENES};
use crate::shot::Shot;
use crate::smooth::Smooth;
use crate::stage::Stage;
use crate::strategy::{ByDirection, Never};
use crate::tracer::{
    BOUNCES, LAMPS_MET, LONGEST_PATH, SKY_SEEN, SPECULAR_BOUNCES, TRUNCATED_PATHS,
};

/// Chapter 12's program.
pub struct PathTracing;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<PathTracing>();

/// The effects this chapter can simulate.
pub const SKILLS: &[Skill] = &[
    Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
    Skill { effect: Effect::AreaLights, unless: "nothing glows" },
    Skill { effect: Effect::IndirectLight, unless: "no surface sends light on" },
    Skill { effect: Effect::MirrorReflection, unless: "nothing is a mirror" },
    Skill { effect: Effect::Refraction, unless: "nothing is glass" },
    Skill { effect: Effect::EnvironmentLight, unless: "all around is black" },
];

/// The work that path tracing counts.
pub const EVENTS: &[Event] = &[
    CAMERA_RAYS,
    BOUNCES,
    SPECULAR_BOUNCES,
    LAMPS_MET,
    SKY_SEEN,
    TRUNCATED_PATHS,
    LONGEST_PATH,
    TRIANGLE_TESTS,
];

impl Chapter for PathTracing {
    const ID: &'static str = "12-path-tracing";
    const ABOUT: &'static str = "Chapter 12: the rendering equation, one path at a time";
    const DEFAULTS: Defaults = Defaults { scene: "cornell", width: 256, height: 256, spp: 64 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = EVENTS;

    type Knobs = Knobs;
    type Scene = Stage<Smooth>;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage<Smooth>, Failure> {
        let mut model = scenes::named(name, knobs.albedo.0)?;
        knobs.aim.apply(&mut model.view);
        Stage::new(&model).map_err(|error| Failure::Usage(error.to_string()))
    }

    fn calls(stage: &Stage<Smooth>, _knobs: &Knobs) -> Vec<Call> {
        stage.calls.clone()
    }

    fn draw<T: Tally>(
        stage: &Stage<Smooth>,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let Knobs { depth, .. } = *knobs;
        let shot = Shot { camera: &stage.camera, lighting: ByDirection, ending: Never, depth };
        let world = stage.world();
        let specular =
            [Effect::MirrorReflection, Effect::Refraction].map(|effect| plan.simulates(effect));
        match world.narrowed(Smooth::lambert) {
            Some(matte) if specular == [false; 2] => shot.draw(&matte, plan, settings),
            _ => shot.draw(&world, plan, settings),
        }
    }

    fn cost() -> Vec<Experiment<'static>> {
        Vec::new()
    }

    fn hard() -> Vec<Case> {
        Vec::new()
    }
}
