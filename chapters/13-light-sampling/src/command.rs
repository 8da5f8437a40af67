//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use path_tracing::bsdf::Bsdf;
use path_tracing::command::SKILLS;
use path_tracing::shot::Shot;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::strategy::{ByDirection, Never};
use path_tracing::tracer::{
    BOUNCES, LAMPS_MET, LONGEST_PATH, SKY_SEEN, SPECULAR_BOUNCES, TRUNCATED_PATHS,
};
use path_tracing::world::World;
use ray_casting::camera::CAMERA_RAYS;
use shadows::visibility::{BLOCKED_RAYS, SHADOW_RAYS};
use triangles::brute::TRIANGLE_TESTS;

use crate::by_light::{ByLight, LIGHT_SAMPLES};
use crate::cost;
use crate::hard;
use crate::knobs::{Counting, Options};
use crate::lights::Lights;
use crate::naive::{Counted, Rule};
use crate::scenes::{self, SCENES};

/// Chapter 13's program.
pub struct LightSampling;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<LightSampling>();

/// The work that light sampling counts.
pub const EVENTS: &[Event] = &[
    CAMERA_RAYS,
    BOUNCES,
    SPECULAR_BOUNCES,
    LIGHT_SAMPLES,
    SHADOW_RAYS,
    BLOCKED_RAYS,
    LAMPS_MET,
    SKY_SEEN,
    TRUNCATED_PATHS,
    LONGEST_PATH,
    TRIANGLE_TESTS,
];

impl Chapter for LightSampling {
    const ID: &'static str = "13-light-sampling";
    const ABOUT: &'static str = "Chapter 13: looking for light where it comes from";
    const DEFAULTS: Defaults = Defaults { scene: "cornell", width: 256, height: 256, spp: 16 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = EVENTS;

    type Knobs = Options;
    type Scene = Stage<Smooth>;

    fn build(name: &str, knobs: &Options) -> Result<Stage<Smooth>, Failure> {
        let path = &knobs.light.path;
        let mut model = scenes::named(name, path.albedo.0)?;
        path.aim.apply(&mut model.view);
        Stage::new(&model).map_err(|error| Failure::Usage(error.to_string()))
    }

    fn calls(stage: &Stage<Smooth>, _knobs: &Options) -> Vec<Call> {
        stage.calls.clone()
    }

    fn draw<T: Tally>(
        stage: &Stage<Smooth>,
        plan: &Plan,
        settings: &Settings,
        knobs: &Options,
    ) -> Rendering<T> {
        let world = stage.world();
        let specular =
            [Effect::MirrorReflection, Effect::Refraction].map(|effect| plan.simulates(effect));
        match world.narrowed(Smooth::lambert) {
            Some(matte) if specular == [false; 2] => lit(&matte, stage, plan, settings, knobs),
            _ => lit(&world, stage, plan, settings, knobs),
        }
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }
}

/// The picture, with light looked for as the options say.
fn lit<B: Bsdf, T: Tally>(
    world: &World<B>,
    stage: &Stage<Smooth>,
    plan: &Plan,
    settings: &Settings,
    knobs: &Options,
) -> Rendering<T> {
    let Options { met, light } = knobs;
    let way = light.lighting.way().filter(|_| plan.simulates(Effect::AreaLights));
    let Some(way) = way else {
        return shot(stage, knobs, ByDirection).draw(world, plan, settings);
    };
    let lights = Lights::new(world.space, &world.surfaces, light.lamps.into(), way);
    let lighting = ByLight { lights: &lights };
    let rule = match met {
        Counting::Once => return shot(stage, knobs, lighting).draw(world, plan, settings),
        Counting::Camera => Rule::OnlyFrom(stage.camera.eye()),
        Counting::Twice => Rule::Always,
    };
    shot(stage, knobs, Counted { lighting, rule }).draw(world, plan, settings)
}

/// How the scene is drawn with this way of looking for light.
fn shot<'a, L>(stage: &'a Stage<Smooth>, knobs: &Options, lighting: L) -> Shot<'a, L, Never> {
    Shot { camera: &stage.camera, lighting, ending: Never, depth: knobs.light.path.depth }
}
