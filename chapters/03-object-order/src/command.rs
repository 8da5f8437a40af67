//! What the chapter's program does.

use clap::Args;
use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::film::{Color, Film};
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Pixel, Rendering, Settings};
use common::tally::{Event, Tally};
use ray_casting::camera::{CAMERA_RAYS, Camera};
use ray_casting::knobs::Aim;
use triangles::brute::TRIANGLE_TESTS;
use triangles::mesh::Mesh;

use crate::fixed::{Fixed, LONGEST_SIDE};
use crate::fragment::{Fragment, Shade};
use crate::parity::{IDS_DIFFER, Judge, UNJUSTIFIED};
use crate::project::Projection;
use crate::raster::{DEPTH_TESTS, PIXELS_TESTED, PIXELS_WRITTEN};
use crate::rasterizer::Rasterizer;
use crate::samples::{exact_position, position};
use crate::scene::{self, Stage};
use crate::setup::{CLIP_TESTS, TRIANGLES_CLIPPED, TRIANGLES_PROJECTED};
use crate::{cost, hard, image, object, shade};

/// Chapter 3.
pub struct ObjectOrder;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<ObjectOrder>();

/// The chapter's own options.
#[derive(Clone, Debug, Default, Args)]
pub struct Knobs {
    /// Which loop is the outer one
    #[arg(long, value_enum, default_value_t)]
    pub order: Order,
    /// What the picture shows
    #[arg(long, value_enum, default_value_t)]
    pub view: ViewChoice,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

/// Which loop is the outer one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Order {
    /// For each triangle, its pixels
    #[default]
    Object,
    /// For each pixel, its triangles
    Image,
}

/// What the picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum ViewChoice {
    /// Directions of the surface as colours
    #[default]
    Normals,
    /// Depth along the line of sight as greys
    Depth,
    /// A colour for each triangle
    Ids,
    /// Both orders, and where they name different triangles
    Difference,
}

impl Chapter for ObjectOrder {
    const ID: &'static str = "03-object-order";
    const ABOUT: &'static str = "Chapter 3: the bunny again, triangle by triangle";
    const DEFAULTS: Defaults = Defaults { scene: "bunny", width: 640, height: 480, spp: 1 };
    const LONGEST_SIDE: u32 = LONGEST_SIDE;
    const SCENES: &'static [SceneName] = scene::SCENES;
    const SKILLS: &'static [Skill] = &[
        Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
        Skill { effect: Effect::SmoothNormals, unless: "the picture shows no vertex normals" },
        Skill { effect: Effect::NearClipping, unless: "no triangle drawn reaches behind the eye" },
    ];
    const EVENTS: &'static [Event] = &[
        TRIANGLES_PROJECTED,
        CLIP_TESTS,
        TRIANGLES_CLIPPED,
        PIXELS_TESTED,
        DEPTH_TESTS,
        PIXELS_WRITTEN,
        CAMERA_RAYS,
        TRIANGLE_TESTS,
        IDS_DIFFER,
        UNJUSTIFIED,
    ];

    type Knobs = Knobs;
    type Scene = Stage;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage, Failure> {
        Stage::named(name, &knobs.aim)
    }

    fn warnings(stage: &Stage) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage, knobs: &Knobs) -> Vec<Call> {
        let mut calls = stage.calls.clone();
        // Normals show in one view only, and rays need no clipping: they never divide by depth.
        let normals = matches!(knobs.view, ViewChoice::Normals | ViewChoice::Difference);
        calls.retain(|call| call.effect != Effect::SmoothNormals || normals);
        let draws = knobs.order == Order::Object || knobs.view == ViewChoice::Difference;
        calls.extend(stage.clipping.clone().filter(|_| draws));
        calls
    }

    fn draw<T: Tally>(
        stage: &Stage,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        Job::new(stage, plan, settings, knobs).run()
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

// ANCHOR: job
/// A picture to be drawn.
struct Job<'a, T> {
    stage: &'a Stage,
    settings: &'a Settings,
    knobs: &'a Knobs,
    camera: Camera,
    /// Prepares the mesh, with clipping or without.
    prepare: fn(&'a Mesh, &Camera, &mut T) -> Rasterizer<'a>,
    /// The colour of a normal, smooth or flat.
    normal: fn(&Mesh, Option<Fragment>) -> Color,
}

impl<'a, T: Tally> Job<'a, T> {
    /// Chooses the functions that do what the plan says. Both exist twice, with the effect and
    /// without, so what is left out costs nothing.
    fn new(stage: &'a Stage, plan: &Plan, settings: &'a Settings, knobs: &'a Knobs) -> Self {
        let camera = stage.camera.with_film(settings.width, settings.height);
        let clip = plan.simulates(Effect::NearClipping);
        let smooth = plan.simulates(Effect::SmoothNormals);
        let prepare = if clip { Rasterizer::new::<true, T> } else { Rasterizer::new::<false, T> };
        let normal = if smooth { shade::normal::<true> } else { shade::normal::<false> };
        Self { stage, settings, knobs, camera, prepare, normal }
    }
    // ANCHOR_END: job

    /// Draws it.
    fn run(&self) -> Rendering<T> {
        let shade =
            |_: Pixel, _: Fixed, fragment: Option<Fragment>, _: &mut T| self.color(fragment);
        match (self.knobs.view, self.knobs.order) {
            (ViewChoice::Difference, _) => self.difference(),
            (_, Order::Object) => self.object_order(&shade),
            (_, Order::Image) => {
                image::render(&self.stage.corners, &self.camera, self.settings, &shade)
            }
        }
    }

    fn object_order(&self, shade: &Shade<T>) -> Rendering<T> {
        let mut setup = T::default();
        let rasterizer = (self.prepare)(&self.stage.mesh, &self.camera, &mut setup);
        let mut rendering = object::render(&rasterizer, self.settings, shade);
        rendering.tally.merge(&setup);
        rendering
    }

    /// Draws in object order, casts a ray at each sample too, and compares.
    fn difference(&self) -> Rendering<T> {
        let Self { stage, camera, .. } = self;
        let judge = Judge::new(&stage.mesh, &Projection::new(camera));
        let shade = |pixel: Pixel, offset: Fixed, object: Option<Fragment>, tally: &mut T| {
            let place = position(pixel, offset);
            let image = image::fragment(&stage.corners, camera, place, tally);
            let verdict = judge.judge(exact_position(pixel, offset), object, image);
            shade::difference(verdict, (self.normal)(&stage.mesh, object), tally)
        };
        let mut rendering = self.object_order(&shade);
        shade::mark(&mut rendering.film);
        rendering
    }

    fn color(&self, fragment: Option<Fragment>) -> Color {
        match self.knobs.view {
            ViewChoice::Depth => shade::depth(self.stage.depths, fragment),
            ViewChoice::Ids => shade::id(fragment),
            ViewChoice::Normals | ViewChoice::Difference => {
                (self.normal)(&self.stage.mesh, fragment)
            }
        }
    }
}
