//! The program.

use common::chapter::{Chapter, Defaults, Failure, SceneName};
use common::cost::Experiment;
use common::film::Film;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use ray_casting::camera::CAMERA_RAYS;
use ray_casting::shape::SHAPE_TESTS;
use shadows::visibility::SHADOW_RAYS;
use whitted::limits::{DEEPEST, Limits, STOPPED_BY_CUTOFF, STOPPED_BY_DEPTH};

use crate::integrator::{REFLECTED, REFRACTED, TOTAL_REFLECTIONS};
use crate::knobs::Knobs;
use crate::picture::Picture;
use crate::scenes::{GlassStage, SCENES};
use crate::{cost, hard};

/// Chapter 7's program.
pub struct Fresnel;

impl Chapter for Fresnel {
    const ID: &'static str = "07-fresnel";
    const ABOUT: &'static str = "Chapter 7: glass and metal, what is reflected and what goes through";
    const DEFAULTS: Defaults = Defaults { scene: "whitted", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = &[
        Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
        Skill { effect: Effect::LocalShading, unless: "no light falls on anything" },
        Skill { effect: Effect::Textures, unless: "every surface has one colour" },
        Skill { effect: Effect::HardShadows, unless: "no lamp is on" },
        Skill { effect: Effect::MirrorReflection, unless: "nothing reflects" },
        Skill { effect: Effect::Refraction, unless: "nothing is glass" },
    ];
    const EVENTS: &'static [Event] = &[
        CAMERA_RAYS,
        SHADOW_RAYS,
        REFLECTED,
        REFRACTED,
        TOTAL_REFLECTIONS,
        DEEPEST,
        STOPPED_BY_DEPTH,
        STOPPED_BY_CUTOFF,
        SHAPE_TESTS,
    ];

    type Knobs = Knobs;
    type Scene = GlassStage;

    fn build(name: &str, knobs: &Knobs) -> Result<GlassStage, Failure> {
        GlassStage::named(name, knobs.index, &knobs.aim)
    }

    fn calls(stage: &GlassStage, _knobs: &Knobs) -> Vec<Call> {
        stage.calls.clone()
    }

    fn draw<T: Tally>(
        stage: &GlassStage,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let limits = Limits { depth: knobs.depth, cutoff: knobs.cutoff };
        let picture =
            Picture { stage, formula: knobs.fresnel, branching: knobs.branch, limits };
        picture.draw(plan, settings)
    }

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
