//! The program: lit scenes with shadows.

use blinn_phong::picture::{LIGHT_SAMPLES, SHADING_POINTS, TEXTURE_LOOKUPS};
use blinn_phong::scenes::{Stage, brute_force};
use common::chapter::{Chapter, Defaults, Failure, SceneName};
use common::cost::Experiment;
use common::film::Film;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use ray_casting::camera::CAMERA_RAYS;
use ray_casting::shape::SHAPE_TESTS;
use triangles::brute::TRIANGLE_TESTS;
use triangles::picture::SMOOTH_NORMALS;

use crate::knobs::Knobs;
use crate::picture::Picture;
use crate::scenes::{SCENES, named};
use crate::visibility::{BLOCKED_RAYS, SHADOW_RAYS};
use crate::{calls, cost, hard};

/// Chapter 5's program.
pub struct Shadows;

/// The effects this chapter can simulate.
pub const SKILLS: &[Skill] = &[
    Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
    Skill { effect: Effect::SmoothNormals, unless: "no mesh has vertex normals" },
    Skill { effect: Effect::LocalShading, unless: "there is no light that a surface returns" },
    Skill { effect: Effect::Textures, unless: "no colour that is lit varies over a surface" },
    Skill { effect: Effect::HardShadows, unless: "no lamp has anything to cast a shadow of" },
];

impl Chapter for Shadows {
    const ID: &'static str = "05-shadows";
    const ABOUT: &'static str = "Chapter 5: the lamps that a surface can see";
    const DEFAULTS: Defaults = Defaults { scene: "three-lamps", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = &[
        CAMERA_RAYS,
        SHADOW_RAYS,
        BLOCKED_RAYS,
        SHAPE_TESTS,
        TRIANGLE_TESTS,
        SHADING_POINTS,
        LIGHT_SAMPLES,
        SMOOTH_NORMALS,
        TEXTURE_LOOKUPS,
    ];

    type Knobs = Knobs;
    type Scene = Stage;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage, Failure> {
        let lamps = knobs.lamps().map_err(|error| Failure::Usage(format!("no light: {error}")))?;
        named(name, brute_force)?.changed(|scene| {
            knobs.aim.apply(&mut scene.view);
            if !lamps.is_empty() {
                scene.lights = lamps;
            }
        })
    }

    fn warnings(stage: &Stage) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage, _knobs: &Knobs) -> Vec<Call> {
        calls::of_scene(&stage.scene, &stage.calls)
    }

    fn draw<T: Tally>(
        stage: &Stage,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let camera = stage.camera.with_film(settings.width, settings.height);
        Picture { scene: &stage.scene, camera, offset: knobs.offset }.draw(settings, plan)
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
