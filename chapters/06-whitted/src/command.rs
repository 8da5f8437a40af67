//! The program: scenes with mirrors.

use blinn_phong::picture::{LIGHT_SAMPLES, SHADING_POINTS, TEXTURE_LOOKUPS};
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

use crate::knobs::Knobs;
use crate::limits::{DEEPEST, Limits, STOPPED_BY_CUTOFF, STOPPED_BY_DEPTH};
use crate::mirror::MIRROR_RAYS;
use crate::picture::Picture;
use crate::scenes::{SCENES, Stage};
use crate::{cost, hard};

/// Chapter 6's program.
pub struct Whitted;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Whitted>();

/// A scene, and how far rays are followed through it.
pub struct Prepared {
    stage: Stage,
    limits: Limits,
}

/// The effects this chapter can simulate.
pub const SKILLS: &[Skill] = &[
    Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
    Skill { effect: Effect::SmoothNormals, unless: "no mesh has vertex normals" },
    Skill { effect: Effect::LocalShading, unless: "there is no light that a surface returns" },
    Skill { effect: Effect::Textures, unless: "no colour that is lit varies over a surface" },
    Skill { effect: Effect::HardShadows, unless: "no lamp is on that lights something" },
    Skill { effect: Effect::MirrorReflection, unless: "no object mirrors" },
];

impl Chapter for Whitted {
    const ID: &'static str = "06-whitted";
    const ABOUT: &'static str = "Chapter 6: mirrors, and rays followed from mirror to mirror";
    const DEFAULTS: Defaults = Defaults { scene: "whitted", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = &[
        CAMERA_RAYS,
        MIRROR_RAYS,
        SHADOW_RAYS,
        SHAPE_TESTS,
        TRIANGLE_TESTS,
        SHADING_POINTS,
        LIGHT_SAMPLES,
        SMOOTH_NORMALS,
        TEXTURE_LOOKUPS,
        DEEPEST,
        STOPPED_BY_DEPTH,
        STOPPED_BY_CUTOFF,
    ];

    type Knobs = Knobs;
    type Scene = Prepared;

    fn build(name: &str, knobs: &Knobs) -> Result<Prepared, Failure> {
        let limits = knobs.limits()?;
        let stage = Stage::named(name, brute_force, |view| knobs.aim.apply(view))?;
        Ok(Prepared { stage, limits })
    }

    fn warnings(scene: &Prepared) -> &[String] {
        &scene.stage.warnings
    }

    fn calls(scene: &Prepared, _knobs: &Knobs) -> Vec<Call> {
        scene.stage.calls.clone()
    }

    fn draw<T: Tally>(
        scene: &Prepared,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let Prepared { stage, limits } = scene;
        let camera = stage.camera.with_film(settings.width, settings.height);
        let picture =
            Picture { scene: &stage.scene, camera, limits: *limits, tracing: knobs.trace };
        picture.draw(settings, plan)
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }

    fn hard_picture() -> Option<Film> {
        hard::picture()
    }
}
