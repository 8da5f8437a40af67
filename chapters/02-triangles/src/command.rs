//! What the chapter's program does.

use clap::Args;
use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::film::Film;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use ray_casting::camera::{CAMERA_RAYS, Camera};
use ray_casting::knobs::Aim;
use ray_casting::picture::Show;

use crate::brute::{TRIANGLE_TESTS, nearest};
use crate::convert::Normals;
use crate::lanes::Packed;
use crate::mesh::Mesh;
use crate::naive::MollerTrumbore;
use crate::picture::{Depths, Picture, SMOOTH_NORMALS};
use crate::reference::DoubleRay;
use crate::scene::{self, MeshScene};
use crate::{cost, hard};

/// Chapter 2.
pub struct Triangles;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Triangles>();

/// The chapter's own options.
#[derive(Clone, Debug, Args)]
pub struct Knobs {
    /// The ray-triangle test
    #[arg(long, value_enum, default_value_t)]
    pub test: TestChoice,
    /// What the picture shows
    #[arg(long, value_enum, default_value_t)]
    pub view: Show,
    /// Where the normals come from
    #[arg(long, value_enum, default_value_t)]
    pub normals: Normals,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

/// A ray-triangle test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum TestChoice {
    /// Möller and Trumbore's, with its epsilon
    Naive,
    /// Woop, Benthin and Wald's
    #[default]
    Watertight,
    /// Möller and Trumbore's in f64
    F64,
}

/// A scene made ready for brute force, with a camera that was found to be possible.
pub struct Stage {
    mesh: Mesh,
    packed: Packed,
    camera: Camera,
    depths: Depths,
    calls: Vec<Call>,
    warnings: Vec<String>,
}

impl Chapter for Triangles {
    const ID: &'static str = "02-triangles";
    const ABOUT: &'static str = "The Stanford bunny: each ray asks each of its 3,674 triangles";
    const DEFAULTS: Defaults = Defaults { scene: "bunny", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = scene::SCENES;
    const SKILLS: &'static [Skill] = &[
        Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
        Skill { effect: Effect::SmoothNormals, unless: "the picture shows no vertex normals" },
    ];
    const EVENTS: &'static [Event] = &[CAMERA_RAYS, TRIANGLE_TESTS, SMOOTH_NORMALS];

    type Knobs = Knobs;
    type Scene = Stage;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage, Failure> {
        let MeshScene { mesh, mut view, warnings, calls, .. } =
            MeshScene::with_normals(name, knobs.normals)?;
        knobs.aim.apply(&mut view);
        let camera = Camera::new(&view, 1, 1);
        let camera = camera.map_err(|error| Failure::Usage(format!("no picture: {error}")))?;
        let depths = Depths::of(&mesh, view.eye);
        let packed = Packed::new(mesh.all_corners());
        Ok(Stage { packed, mesh, camera, depths, calls, warnings })
    }

    fn warnings(stage: &Stage) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage, knobs: &Knobs) -> Vec<Call> {
        let mut calls = stage.calls.clone();
        // A picture of depth shows no normals, whatever the mesh has.
        calls.retain(|it| it.effect != Effect::SmoothNormals || knobs.view == Show::Normals);
        calls
    }

    fn draw<T: Tally>(
        stage: &Stage,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let Stage { mesh, packed, camera, depths, .. } = stage;
        let camera = camera.with_film(settings.width, settings.height);
        let picture = Picture { mesh, camera, show: knobs.view, depths: *depths };
        let smooth = plan.simulates(Effect::SmoothNormals);
        let (all, far) = (packed.corners(), f32::INFINITY);
        let count_all = |tally: &mut T| tally.count(TRIANGLE_TESTS, packed.len() as u64);
        match knobs.test {
            TestChoice::Watertight => picture.draw(settings, smooth, |ray, tally| {
                count_all(tally);
                packed.nearest(ray, far)
            }),
            TestChoice::Naive => picture.draw(settings, smooth, |ray, tally| {
                count_all(tally);
                nearest::<MollerTrumbore>(all, ray, far)
            }),
            TestChoice::F64 => picture.draw(settings, smooth, |ray, tally| {
                count_all(tally);
                nearest::<DoubleRay>(all, ray, far)
            }),
        }
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
