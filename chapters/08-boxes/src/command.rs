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
use triangles::brute::TRIANGLE_TESTS;
use triangles::convert::Normals;
use triangles::lanes::Packed;
use triangles::mesh::Mesh;
use triangles::picture::SMOOTH_NORMALS;
use triangles::scene::{self, MeshScene};

use crate::aabb::Aabb;
use crate::parts::Parts;
use crate::picture::{Picture, Show};
use crate::slab::BOX_TESTS;
use crate::{cost, hard};

/// Chapter 8.
pub struct Boxes;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Boxes>();

/// The chapter's own options.
#[derive(Clone, Debug, Args)]
pub struct Knobs {
    /// What stands before the triangles
    #[arg(long, value_enum, default_value_t)]
    pub accel: Accel,
    /// How many boxes, each around as many triangles
    #[arg(long, allow_hyphen_values = true, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=MOST_BOXES))]
    pub boxes: u32,
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

const MOST_BOXES: i64 = 1 << 24;

/// How the nearest triangle is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Accel {
    /// Nothing: every ray asks every triangle
    None,
    /// Boxes: a triangle is asked when its box is met
    #[default]
    Box,
}

/// A scene in both forms, with a camera that was found to be possible.
pub struct Stage {
    mesh: Mesh,
    all: Packed,
    parts: Parts,
    boxes: Vec<Aabb>,
    camera: Camera,
    calls: Vec<Call>,
    warnings: Vec<String>,
}

impl Chapter for Boxes {
    const ID: &'static str = "08-boxes";
    const ABOUT: &'static str =
        "Chapter 8: the bunny in a box, and rays that miss the box ask no triangle";
    const DEFAULTS: Defaults = Defaults { scene: "bunny", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = scene::SCENES;
    const SKILLS: &'static [Skill] = &[
        Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
        Skill { effect: Effect::SmoothNormals, unless: "the picture shows no vertex normals" },
    ];
    const EVENTS: &'static [Event] = &[CAMERA_RAYS, BOX_TESTS, TRIANGLE_TESTS, SMOOTH_NORMALS];

    type Knobs = Knobs;
    type Scene = Stage;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage, Failure> {
        let MeshScene { mesh, mut view, warnings, calls, .. } =
            MeshScene::with_normals(name, knobs.normals)?;
        knobs.aim.apply(&mut view);
        let camera = Camera::new(&view, 1, 1);
        let camera = camera.map_err(|error| Failure::Usage(format!("no picture: {error}")))?;
        let corners = mesh.all_corners();
        let parts = Parts::new(&corners, knobs.boxes as usize);
        let boxes = parts.boxes().copied().collect();
        Ok(Stage { mesh, all: Packed::new(corners), parts, boxes, camera, calls, warnings })
    }

    fn warnings(stage: &Stage) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage, knobs: &Knobs) -> Vec<Call> {
        let mut calls = stage.calls.clone();
        // A picture of the work shows no normals, whatever the mesh has.
        calls.retain(|it| it.effect != Effect::SmoothNormals || knobs.view != Show::Work);
        calls
    }

    fn draw<T: Tally>(
        stage: &Stage,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let Stage { mesh, all, parts, boxes, camera, .. } = stage;
        let camera = camera.with_film(settings.width, settings.height);
        let thickness = WIRE * parts.bounds().size().max_element();
        let picture = Picture { mesh, boxes, thickness, camera, show: knobs.view };
        let smooth = plan.simulates(Effect::SmoothNormals);
        let far = f32::INFINITY;
        match knobs.accel {
            Accel::None => picture.draw(settings, smooth, |ray, work| {
                work.count(TRIANGLE_TESTS, all.len() as u64);
                all.nearest(ray, far)
            }),
            Accel::Box => picture.draw(settings, smooth, |ray, work| parts.nearest(ray, far, work)),
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

/// The thickness of a drawn edge, as a part of the scene's longest side.
const WIRE: f32 = 0.006;

#[cfg(test)]
mod tests {
    use common::chapter::{Asked, Chapter, knobs};
    use common::plan::Simulate;
    use common::render::Settings;
    use common::tally::Counts;
    use triangles::brute::TRIANGLE_TESTS;
    use triangles::command::Triangles;
    use triangles::picture::SMOOTH_NORMALS;

    use super::{Accel, Boxes, Knobs};
    use crate::picture::Show;
    use crate::slab::BOX_TESTS;

    /// The hash of chapter `C`'s picture for these options, and its counters.
    fn drawn<C: Chapter>(options: &str, simulate: Simulate) -> (u64, Counts) {
        let settings = Settings { width: 40, height: 30, spp: 2, ..Settings::default() };
        let asked = Asked { scene: "bunny", options, simulate };
        let made = asked.draw::<C>(&settings).expect("it is built in");
        assert_eq!(made.film.nonfinite, 0);
        (made.film.hash(), made.tally)
    }

    /// The lesson: with a box, without one, and in chapter 2, the same bits; the work differs.
    #[test]
    fn a_box_changes_the_work_and_no_bit() {
        let (brute, _) = drawn::<Triangles>("", Simulate::Needed);
        let mut work = Vec::new();
        for options in ["--accel none", "", "--boxes 16", "--boxes 3674"] {
            let options = format!("--view normals {options}");
            let (hash, counts) = drawn::<Boxes>(&options, Simulate::Needed);
            assert_eq!(hash, brute, "{options}");
            work.push((counts.of(BOX_TESTS), counts.of(TRIANGLE_TESTS)));
        }
        let rays = 2 * 40 * 30;
        assert_eq!(work[0], (0, rays * 3674));
        assert_eq!(work[1].0, rays);
        assert!(work[1].1 < work[0].1 && work[2].1 < work[1].1 && work[3].1 < work[2].1);
        assert_eq!(work[3].0, rays * 3674);
    }

    #[test]
    fn the_wires_are_the_same_with_and_without() {
        let with = |options| drawn::<Boxes>(options, Simulate::Needed).0;
        assert_eq!(with("--boxes 8 --accel none"), with("--boxes 8"));
        assert_ne!(with("--boxes 8"), with("--boxes 9"));
    }

    #[test]
    fn a_picture_of_work_needs_no_normals() {
        let (needed, counts) = drawn::<Boxes>("--view work", Simulate::Needed);
        assert_eq!(counts.of(SMOOTH_NORMALS), 0);
        assert_eq!(drawn::<Boxes>("--view work", Simulate::All).0, needed);
        assert_ne!(drawn::<Boxes>("--view work --accel none", Simulate::Needed).0, needed);
    }

    #[test]
    fn the_defaults_are_a_box_that_is_shown() {
        let Knobs { accel, boxes, view, .. } = knobs::<Boxes>("").expect("no option");
        assert_eq!((accel, boxes, view), (Accel::Box, 1, Show::Boxes));
    }
}
