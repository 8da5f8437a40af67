//! The program: pictures of normals and of depth.

use std::path::Path;

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName, unknown_scene};
use common::cost::Experiment;
use common::film::Film;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};

use crate::camera::{CAMERA_RAYS, Camera};
use crate::knobs::{Knobs, Lens};
use crate::picture::{self, Picture};
use crate::scene::{self, Geometry, SphereShape};
use crate::shape::SHAPE_TESTS;
use crate::{cost, hard};

/// Chapter 1's program.
pub struct RayCasting;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<RayCasting>();

/// A scene with a camera that was found to be possible.
pub struct Scene {
    geometry: Geometry,
    camera: Camera,
}

impl Chapter for RayCasting {
    const ID: &'static str = "01-ray-casting";
    const ABOUT: &'static str = "Chapter 1: one ray for each pixel, shown as normals or depth";
    const DEFAULTS: Defaults = Defaults { scene: "whitted", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = &[
        SceneName { name: "whitted", about: "the report's two spheres over a floor" },
        SceneName { name: "ground", about: "a ball on a ground that is a sphere of radius 10^7" },
        SceneName { name: "far", about: "a sphere of radius 1, 10^4 away, through a long lens" },
        SceneName { name: "horizon", about: "a ball over a plane that ends nowhere" },
        SceneName { name: "empty", about: "nothing at all" },
    ];
    const SKILLS: &'static [Skill] =
        &[Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" }];
    const EVENTS: &'static [Event] = &[CAMERA_RAYS, SHAPE_TESTS];

    type Knobs = Knobs;
    type Scene = Scene;

    fn build(name: &str, knobs: &Knobs) -> Result<Scene, Failure> {
        let mut geometry = geometry(name, knobs.sphere.shape())?;
        knobs.aim.apply(&mut geometry.view);
        let camera = Camera::new(&geometry.view, 1, 1);
        let camera = camera.map_err(|error| Failure::Usage(format!("no picture: {error}")))?;
        Ok(Scene { geometry, camera })
    }

    fn calls(scene: &Scene, _knobs: &Knobs) -> Vec<Call> {
        scene.geometry.calls.clone()
    }

    fn draw<T: Tally>(
        scene: &Scene,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let Scene { geometry, camera } = scene;
        let camera = camera.with_film(settings.width, settings.height);
        let picture = Picture { geometry, camera, show: knobs.view };
        if !plan.simulates(Effect::PrimaryVisibility) {
            return picture.draw_nothing(settings);
        }
        match knobs.camera {
            Lens::Frame => picture.draw(settings, |position| camera.ray(position)),
            Lens::Report => {
                picture.draw(settings, |position| picture::report_ray(&camera, position))
            }
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

/// The scene called `name`.
fn geometry(name: &str, sphere: SphereShape) -> Result<Geometry, Failure> {
    match name {
        "whitted" => Ok(scene::whitted(sphere)),
        "ground" => Ok(scene::ground(sphere)),
        "far" => Ok(scene::far(sphere)),
        "horizon" => Ok(scene::horizon(sphere)),
        "empty" => Ok(scene::empty()),
        file if is_mesh(file) => Err(Failure::Usage(format!(
            "'{file}' is a mesh, and meshes come in chapter 2: \
             cargo run --release -p triangles -- --scene '{file}'"
        ))),
        file if Path::new(file).is_file() => Err(Failure::Usage(format!(
            "'{file}' is a file, and this chapter reads none; --help lists its scenes"
        ))),
        other => Err(unknown_scene(other, RayCasting::SCENES)),
    }
}

/// Whether a scene's name is that of a mesh file.
fn is_mesh(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("obj"))
}

#[cfg(test)]
mod tests {
    use common::chapter::{Chapter, Entry, Failure};
    use common::plan::{Plan, Simulate};
    use common::render::Settings;
    use common::tally::{Counts, Off};
    use glam::Vec3;

    use super::RayCasting;
    use crate::camera::CAMERA_RAYS;
    use crate::knobs::{Aim, Formula, Knobs, Lens, Point};
    use crate::picture::Show;
    use crate::shape::SHAPE_TESTS;

    const SETTINGS: fn() -> Settings = || Settings { width: 40, height: 30, ..Settings::default() };

    fn plan(name: &str, knobs: &Knobs, simulate: Simulate) -> Plan {
        let scene = RayCasting::build(name, knobs).expect("a scene");
        Plan::new(&RayCasting::calls(&scene, knobs), RayCasting::SKILLS, simulate)
    }

    fn hash(name: &str, knobs: &Knobs, simulate: Simulate) -> u64 {
        let scene = RayCasting::build(name, knobs).expect("a scene");
        let plan = plan(name, knobs, simulate);
        RayCasting::draw::<Off>(&scene, &plan, &SETTINGS(), knobs).film.hash()
    }

    #[test]
    fn every_scene_in_every_way_is_finite() {
        for scene in RayCasting::SCENES {
            for sphere in [Formula::Naive, Formula::Stable, Formula::F64] {
                for view in [Show::Normals, Show::Depth] {
                    let knobs = Knobs { sphere, view, ..Knobs::default() };
                    let built = RayCasting::build(scene.name, &knobs).expect("a scene");
                    let plan = plan(scene.name, &knobs, Simulate::Needed);
                    let made = RayCasting::draw::<Off>(&built, &plan, &SETTINGS(), &knobs);
                    assert_eq!(made.film.nonfinite, 0, "{} {sphere:?}", scene.name);
                }
            }
        }
    }

    #[test]
    fn an_empty_scene_costs_nothing_and_looks_the_same() {
        let knobs = Knobs::default();
        let scene = RayCasting::build("empty", &knobs).expect("a scene");
        let count = |simulate| {
            let plan = plan("empty", &knobs, simulate);
            RayCasting::draw::<Counts>(&scene, &plan, &SETTINGS(), &knobs).tally.of(CAMERA_RAYS)
        };
        assert_eq!((count(Simulate::Needed), count(Simulate::All)), (0, 1200));
        let picture = |simulate| hash("empty", &knobs, simulate);
        assert_eq!(picture(Simulate::Needed), picture(Simulate::All));
    }

    #[test]
    fn a_ray_asks_every_shape() {
        let knobs = Knobs::default();
        let scene = RayCasting::build("whitted", &knobs).expect("a scene");
        let plan = plan("whitted", &knobs, Simulate::Needed);
        let tally = RayCasting::draw::<Counts>(&scene, &plan, &SETTINGS(), &knobs).tally;
        assert_eq!((tally.of(CAMERA_RAYS), tally.of(SHAPE_TESTS)), (1200, 3600));
    }

    /// Erratum 6: the report's camera draws another picture as soon as the eye has moved.
    #[test]
    fn the_report_s_camera_and_an_eye_that_moved() {
        let aim = Aim { eye: Some(Point(Vec3::Y)), ..Aim::default() };
        let moved = Knobs { aim, ..Knobs::default() };
        let report = Knobs { camera: Lens::Report, ..moved.clone() };
        assert_ne!(
            hash("whitted", &moved, Simulate::Needed),
            hash("whitted", &report, Simulate::Needed)
        );
    }

    #[test]
    fn help_tells_the_defaults() {
        let run = Entry::of::<RayCasting>().run;
        let Err(Failure::CommandLine(help)) = run(&["--help".into()], &mut Vec::new()) else {
            panic!("help is not a picture")
        };
        let text = help.to_string();
        for default in ["whitted", "640x480", "1", "out/01-ray-casting.png"] {
            assert!(text.contains(&format!("[default: {default}]")), "{default}: {text}");
        }
    }

    #[test]
    fn a_mesh_is_sent_to_chapter_2() {
        let refused = RayCasting::build("bunny.OBJ", &Knobs::default());
        let Err(Failure::Usage(message)) = refused else { panic!("it was accepted") };
        assert!(message.contains("-p triangles -- --scene 'bunny.OBJ'"), "{message}");
    }
}
