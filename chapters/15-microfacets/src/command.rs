//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::film::Film;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use path_tracing::bsdf::Bsdf;
use path_tracing::command::EVENTS;
use path_tracing::shot::Shot;
use path_tracing::stage::Stage;
use path_tracing::strategy::{ByDirection, Never};
use path_tracing::world::World;

use crate::finish::Finish;
use crate::knobs::Knobs;
use crate::scenes::{self, SCENES};
use crate::{cost, hard};

/// Chapter 15's program.
pub struct Microfacets;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Microfacets>();

/// The effects this chapter can simulate.
pub const SKILLS: &[Skill] = &[
    Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
    Skill { effect: Effect::AreaLights, unless: "nothing glows" },
    Skill { effect: Effect::IndirectLight, unless: "no surface sends light on" },
    Skill { effect: Effect::MirrorReflection, unless: "nothing is a mirror" },
    Skill { effect: Effect::Refraction, unless: "nothing is clear glass" },
    Skill { effect: Effect::GlossyReflection, unless: "no metal and no glass is rough" },
    Skill { effect: Effect::EnvironmentLight, unless: "all around is black" },
];

impl Chapter for Microfacets {
    const ID: &'static str = "15-microfacets";
    const ABOUT: &'static str = "Chapter 15: rough metal and rough glass";
    const DEFAULTS: Defaults = Defaults { scene: "polish", width: 640, height: 400, spp: 16 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = EVENTS;

    type Knobs = Knobs;
    type Scene = Stage<Finish>;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage<Finish>, Failure> {
        let path = &knobs.path;
        let mut model = scenes::named(name, path.albedo.0)?;
        path.aim.apply(&mut model.view);
        let model = model.map(|finish| finish.with_facets(|facets| knobs.apply(facets)));
        Stage::new(&model).map_err(|error| Failure::Usage(error.to_string()))
    }

    fn calls(stage: &Stage<Finish>, _knobs: &Knobs) -> Vec<Call> {
        stage.calls.clone()
    }

    // ANCHOR: draw
    fn draw<T: Tally>(
        stage: &Stage<Finish>,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let world = stage.world();
        let specular = [Effect::MirrorReflection, Effect::Refraction];
        let specular = specular.iter().any(|&effect| plan.simulates(effect));
        if plan.simulates(Effect::GlossyReflection) {
            return lit(&world, stage, plan, settings, knobs);
        }
        // Nothing rough is simulated: materials that have no case for it.
        match (world.narrowed(Finish::lambert), world.narrowed(Finish::smooth)) {
            (Some(matte), _) if !specular => lit(&matte, stage, plan, settings, knobs),
            (_, Some(smooth)) => lit(&smooth, stage, plan, settings, knobs),
            _ => lit(&world, stage, plan, settings, knobs),
        }
    }
    // ANCHOR_END: draw

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }

    fn hard_picture() -> Option<Film> {
        Some(hard::picture())
    }
}

/// The picture, of any materials.
fn lit<B: Bsdf, T: Tally>(
    world: &World<B>,
    stage: &Stage<Finish>,
    plan: &Plan,
    settings: &Settings,
    knobs: &Knobs,
) -> Rendering<T> {
    let (camera, ending, depth) = (&stage.camera, Never, knobs.path.depth);
    Shot { camera, lighting: ByDirection, ending, depth }.draw(world, plan, settings)
}
