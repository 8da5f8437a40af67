//! The program: lit scenes.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
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

use crate::knobs::{Knobs, ModelChoice};
use crate::models::{Blinn, Lambert, Normalized, Phong};
use crate::naive::Published;
use crate::picture::{LIGHT_SAMPLES, Picture, SHADING_POINTS, TEXTURE_LOOKUPS};
use crate::scenes::{SCENES, Stage, brute_force};
use crate::{cost, hard};

/// Chapter 4's program.
pub struct LitScenes;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<LitScenes>();

/// The effects this chapter can simulate.
pub const SKILLS: &[Skill] = &[
    Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
    Skill { effect: Effect::SmoothNormals, unless: "no mesh has vertex normals" },
    Skill { effect: Effect::LocalShading, unless: "there is no light that a surface returns" },
    Skill { effect: Effect::Textures, unless: "no colour that is lit varies over a surface" },
];

impl Chapter for LitScenes {
    const ID: &'static str = "04-blinn-phong";
    const ABOUT: &'static str = "Chapter 4: the light of lamps, and what surfaces return of it";
    const DEFAULTS: Defaults = Defaults { scene: "whitted", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = &[
        CAMERA_RAYS,
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
        knobs.apply(Stage::named(name, brute_force)?)
    }

    fn warnings(stage: &Stage) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage, _knobs: &Knobs) -> Vec<Call> {
        stage.calls.clone()
    }

    fn draw<T: Tally>(
        stage: &Stage,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let camera = stage.camera.with_film(settings.width, settings.height);
        let picture = Picture { scene: &stage.scene, camera };
        match knobs.model {
            ModelChoice::Lambert => picture.draw::<Lambert, T>(settings, plan),
            ModelChoice::Phong => picture.draw::<Phong, T>(settings, plan),
            ModelChoice::BlinnPhong => picture.draw::<Blinn, T>(settings, plan),
            ModelChoice::Normalized => picture.draw::<Normalized, T>(settings, plan),
            ModelChoice::Published => picture.draw::<Published, T>(settings, plan),
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

#[cfg(test)]
mod tests {
    use clap::ValueEnum;
    use common::plan::{Plan, Simulate};
    use common::render::Settings;
    use common::tally::{Counts, Event};
    use glam::Vec3;
    use ray_casting::camera::CAMERA_RAYS;
    use ray_casting::knobs::Point;

    use super::{Chapter, Knobs, LitScenes, ModelChoice, SKILLS, Stage};
    use crate::knobs::Amount;
    use crate::picture::{LIGHT_SAMPLES, SHADING_POINTS, TEXTURE_LOOKUPS};

    /// The picture's hash, its samples that are no number, and its counters.
    fn drawn(stage: &Stage, knobs: &Knobs, simulate: Simulate) -> (u64, u64, Counts) {
        let plan = Plan::new(&LitScenes::calls(stage, knobs), SKILLS, simulate);
        let settings = Settings { width: 40, height: 30, ..Settings::default() };
        let made = LitScenes::draw::<Counts>(stage, &plan, &settings, knobs);
        (made.film.hash(), made.film.nonfinite, made.tally)
    }

    fn counters(name: &str, simulate: Simulate) -> [u64; 4] {
        let knobs = Knobs::default();
        let stage = LitScenes::build(name, &knobs).expect("it is built in");
        let (_, _, counts) = drawn(&stage, &knobs, simulate);
        [CAMERA_RAYS, SHADING_POINTS, LIGHT_SAMPLES, TEXTURE_LOOKUPS].map(|it: Event| counts.of(it))
    }

    const BUILT_IN: [&str; 6] = ["whitted", "low-lamp", "two-lamps", "sphere:60", "dark", "empty"];

    #[test]
    fn what_is_not_called_for_changes_no_bit_and_is_not_done() {
        for name in BUILT_IN {
            for &model in ModelChoice::value_variants() {
                let knobs = Knobs { model, ..Knobs::default() };
                let stage = LitScenes::build(name, &knobs).expect("it is built in");
                let [needed, all] = [Simulate::Needed, Simulate::All]
                    .map(|simulate| drawn(&stage, &knobs, simulate).0);
                assert_eq!(needed, all, "{name} {model:?}");
            }
        }
        let [rays, shaded, samples, lookups] = counters("whitted", Simulate::Needed);
        assert!(rays == 1200 && 0 < lookups && lookups < shaded && samples == 2 * shaded);
        assert_eq!(counters("empty", Simulate::Needed), [0; 4]);
        assert_eq!(counters("dark", Simulate::Needed), [1200, 0, 0, 0]);
        let [_, shaded, _, lookups] = counters("low-lamp", Simulate::Needed);
        assert!(shaded > 0 && lookups == 0);
        assert_eq!(counters("dark", Simulate::All)[1], counters("whitted", Simulate::Needed)[1]);
    }

    #[test]
    fn nothing_extreme_makes_a_pixel_that_is_no_number() {
        let inside = Point(Vec3::new(-1.0, 0.0, -12.0));
        let at_the_eye = Point(Vec3::ZERO);
        let far = Point(Vec3::splat(3e38));
        let models = [ModelChoice::Lambert, ModelChoice::Phong, ModelChoice::BlinnPhong];
        for model in models.into_iter().chain([ModelChoice::Normalized]) {
            for lamp in [inside, at_the_eye, far] {
                for falloff in [Vec3::X, Vec3::Z, Vec3::Z * 1e-38, Vec3::splat(3e38)] {
                    for shininess in [0.0, 1e-30, 2.5, 1e6, 1e9] {
                        let knobs = Knobs {
                            model,
                            lamp: Some(lamp),
                            falloff: Some(Point(falloff)),
                            shininess: Some(Amount(shininess)),
                            ambient: Some(Amount(1e9)),
                            ..Knobs::default()
                        };
                        let stage = LitScenes::build("whitted", &knobs).expect("all of it can be");
                        let (_, nonfinite, _) = drawn(&stage, &knobs, Simulate::Needed);
                        assert_eq!(nonfinite, 0, "{knobs:?}");
                    }
                }
            }
        }
    }

    /// Erratum 9: the same picture by the published line.
    #[test]
    fn the_published_line_has_pixels_that_are_no_number() {
        let knobs = Knobs {
            model: ModelChoice::Published,
            shininess: Some(Amount(2.5)),
            ..Knobs::default()
        };
        let stage = LitScenes::build("two-lamps", &knobs).expect("it is built in");
        assert!(drawn(&stage, &knobs, Simulate::Needed).1 > 0);
    }
}
