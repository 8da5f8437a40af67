//! The program: lit scenes with shadows.

use blinn_phong::picture::{LIGHT_SAMPLES, SHADING_POINTS, TEXTURE_LOOKUPS};
use blinn_phong::scenes::{Stage, brute_force};
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

use crate::knobs::Knobs;
use crate::picture::Picture;
use crate::scenes::{SCENES, named};
use crate::visibility::{BLOCKED_RAYS, SHADOW_RAYS};
use crate::{calls, cost, hard};

/// Chapter 5's program.
pub struct Shadows;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Shadows>();

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

#[cfg(test)]
mod tests {
    use common::plan::{Plan, Simulate};
    use common::render::Settings;
    use common::tally::Counts;
    use glam::Vec3;
    use ray_casting::knobs::{Aim, Point};

    use super::{Chapter, Knobs, SKILLS, Shadows};
    use crate::offset::Offset;
    use crate::visibility::{BLOCKED_RAYS, SHADOW_RAYS};

    /// The picture's hash, its samples that are no number, and its shadow rays.
    fn drawn(name: &str, knobs: &Knobs, simulate: Simulate) -> (u64, u64, [u64; 2]) {
        let stage = Shadows::build(name, knobs).expect("it can be built");
        let plan = Plan::new(&Shadows::calls(&stage, knobs), SKILLS, simulate);
        let settings = Settings { width: 48, height: 36, ..Settings::default() };
        let made = Shadows::draw::<Counts>(&stage, &plan, &settings, knobs);
        let rays = [SHADOW_RAYS, BLOCKED_RAYS].map(|event| made.tally.of(event));
        (made.film.hash(), made.film.nonfinite, rays)
    }

    #[test]
    fn what_is_not_called_for_changes_no_bit_and_is_not_done() {
        let knobs = Knobs::default();
        for name in ["three-lamps", "alone", "whitted", "two-lamps", "sphere:60", "dark", "empty"] {
            let needed = drawn(name, &knobs, Simulate::Needed);
            let all = drawn(name, &knobs, Simulate::All);
            assert_eq!(needed.0, all.0, "{name}");
            let casts = !["alone", "dark", "empty"].contains(&name);
            assert_eq!(needed.2[0] > 0, casts, "{name}");
        }
        let [asked, blocked] = drawn("alone", &knobs, Simulate::All).2;
        assert!(asked > 0 && blocked == 0, "every ray of the lone ball was for nothing");
    }

    #[test]
    fn the_same_scene_in_three_sizes_is_the_same_picture_to_the_bit() {
        let hash =
            |name, offset| drawn(name, &Knobs { offset, ..Knobs::default() }, Simulate::Needed).0;
        for name in ["small", "large"] {
            assert_eq!(hash(name, Offset::Bound), hash("three-lamps", Offset::Bound), "{name}");
            for offset in [Offset::Fixed, Offset::Normal] {
                assert_ne!(hash(name, offset), hash("three-lamps", offset), "{name} {offset:?}");
            }
        }
    }

    #[test]
    fn without_an_offset_surfaces_are_in_their_own_way() {
        let blocked =
            |offset| drawn("far", &Knobs { offset, ..Knobs::default() }, Simulate::Needed).2[1];
        let [none, bound] = [Offset::None, Offset::Bound].map(blocked);
        assert!(none > bound + bound / 2, "{none} {bound}");
    }

    #[test]
    fn no_lamp_makes_a_pixel_that_is_no_number() {
        let inside = Vec3::new(-1.1, 1.0, -0.4);
        let lamps = [inside, inside + Vec3::Y, Vec3::ZERO, Vec3::splat(3e38), Vec3::splat(1e-40)];
        for lamp in lamps {
            for offset in Offset::ALL {
                for scene in ["three-lamps", "far", "whitted"] {
                    let knobs = Knobs { offset, lamp: Some(Point(lamp)), ..Knobs::default() };
                    assert_eq!(drawn(scene, &knobs, Simulate::Needed).1, 0, "{scene} {knobs:?}");
                    let aim = Aim { eye: Some(Point(inside)), ..Aim::default() };
                    let knobs = Knobs { aim, ..knobs };
                    assert_eq!(drawn(scene, &knobs, Simulate::Needed).1, 0, "{scene} {knobs:?}");
                }
            }
        }
    }

    #[test]
    fn a_lamp_that_shines_from_inside_a_ball_lights_nothing_outside() {
        let lamp = Some(Point(Vec3::new(-1.1, 1.0, -0.4)));
        let [asked, blocked] =
            drawn("three-lamps", &Knobs { lamp, ..Knobs::default() }, Simulate::Needed).2;
        assert!(asked > 0 && asked == blocked);
    }
}
