//! The program.

use blinn_phong::scenes::brute_force;
use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::film::Film;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use ray_casting::camera::CAMERA_RAYS;
use ray_casting::shape::SHAPE_TESTS;
use shadows::visibility::SHADOW_RAYS;
use triangles::brute::TRIANGLE_TESTS;
use triangles::picture::SMOOTH_NORMALS;
use whitted::limits::{DEEPEST, STOPPED_BY_CUTOFF, STOPPED_BY_DEPTH};
use whitted::mirror::MIRROR_RAYS;

use crate::curves::Curves;
use crate::integrator::{REFLECTED, REFRACTED, TOTAL_REFLECTIONS};
use crate::knobs::Knobs;
use crate::picture::Picture;
use crate::scenes::{SCENES, Stage};
use crate::{cost, hard};

/// Chapter 7's program.
pub struct Fresnel;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Fresnel>();

/// What there is to draw.
pub enum Subject {
    /// A scene.
    Scene(Box<Stage>),
    /// A chart.
    Curves(Curves),
}

/// The effects this chapter can simulate.
pub const SKILLS: &[Skill] = &[
    Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
    Skill { effect: Effect::SmoothNormals, unless: "no mesh has vertex normals" },
    Skill { effect: Effect::LocalShading, unless: "there is no light that a surface returns" },
    Skill { effect: Effect::Textures, unless: "no colour that is lit varies over a surface" },
    Skill { effect: Effect::HardShadows, unless: "no lamp is on that lights something" },
    Skill { effect: Effect::MirrorReflection, unless: "no object mirrors" },
    Skill { effect: Effect::Refraction, unless: "no object is glass" },
];

impl Chapter for Fresnel {
    const ID: &'static str = "07-fresnel";
    const ABOUT: &'static str =
        "Chapter 7: glass and metal, what is reflected and what goes through";
    const DEFAULTS: Defaults = Defaults { scene: "whitted", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = &[
        CAMERA_RAYS,
        MIRROR_RAYS,
        REFLECTED,
        REFRACTED,
        TOTAL_REFLECTIONS,
        SHADOW_RAYS,
        SHAPE_TESTS,
        TRIANGLE_TESTS,
        SMOOTH_NORMALS,
        DEEPEST,
        STOPPED_BY_DEPTH,
        STOPPED_BY_CUTOFF,
    ];

    type Knobs = Knobs;
    type Scene = Subject;

    fn build(name: &str, knobs: &Knobs) -> Result<Subject, Failure> {
        if name == "curves" {
            return Ok(Subject::Curves(Curves { index: knobs.index }));
        }
        let stage = Stage::named(name, brute_force, knobs.index, |view| knobs.aim.apply(view))?;
        Ok(Subject::Scene(Box::new(stage)))
    }

    fn warnings(subject: &Subject) -> &[String] {
        match subject {
            Subject::Scene(stage) => &stage.warnings,
            Subject::Curves(_) => &[],
        }
    }

    fn calls(subject: &Subject, _knobs: &Knobs) -> Vec<Call> {
        match subject {
            Subject::Scene(stage) => stage.calls.clone(),
            Subject::Curves(_) => Vec::new(),
        }
    }

    fn draw<T: Tally>(
        subject: &Subject,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        match subject {
            Subject::Scene(stage) => {
                let (formula, branching) = (knobs.fresnel, knobs.branch);
                let picture = Picture { stage, formula, branching, limits: knobs.limits() };
                picture.draw(plan, settings)
            }
            Subject::Curves(curves) => curves.draw(settings),
        }
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
