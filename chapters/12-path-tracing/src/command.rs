//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use ray_casting::camera::CAMERA_RAYS;
use triangles::brute::TRIANGLE_TESTS;

use crate::knobs::Knobs;
use crate::scenes::{self, SCENES};
use crate::shot::Shot;
use crate::smooth::Smooth;
use crate::stage::Stage;
use crate::strategy::{ByDirection, Never};
use crate::tracer::{
    BOUNCES, LAMPS_MET, LONGEST_PATH, SKY_SEEN, SPECULAR_BOUNCES, TRUNCATED_PATHS,
};
use crate::{cost, hard};

/// Chapter 12's program.
pub struct PathTracing;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<PathTracing>();

/// The effects this chapter can simulate.
pub const SKILLS: &[Skill] = &[
    Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
    Skill { effect: Effect::AreaLights, unless: "nothing glows" },
    Skill { effect: Effect::IndirectLight, unless: "no surface sends light on" },
    Skill { effect: Effect::MirrorReflection, unless: "nothing is a mirror" },
    Skill { effect: Effect::Refraction, unless: "nothing is glass" },
    Skill { effect: Effect::EnvironmentLight, unless: "all around is black" },
];

/// The work that path tracing counts.
pub const EVENTS: &[Event] = &[
    CAMERA_RAYS,
    BOUNCES,
    SPECULAR_BOUNCES,
    LAMPS_MET,
    SKY_SEEN,
    TRUNCATED_PATHS,
    LONGEST_PATH,
    TRIANGLE_TESTS,
];

impl Chapter for PathTracing {
    const ID: &'static str = "12-path-tracing";
    const ABOUT: &'static str = "Chapter 12: the rendering equation, one path at a time";
    const DEFAULTS: Defaults = Defaults { scene: "cornell", width: 256, height: 256, spp: 64 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = EVENTS;

    type Knobs = Knobs;
    type Scene = Stage<Smooth>;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage<Smooth>, Failure> {
        let mut model = scenes::named(name, knobs.albedo.0)?;
        knobs.aim.apply(&mut model.view);
        Stage::new(&model).map_err(|error| Failure::Usage(error.to_string()))
    }

    fn warnings(stage: &Stage<Smooth>) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage<Smooth>, _knobs: &Knobs) -> Vec<Call> {
        stage.calls.clone()
    }

    fn draw<T: Tally>(
        stage: &Stage<Smooth>,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let Knobs { depth, .. } = *knobs;
        let shot = Shot { camera: &stage.camera, lighting: ByDirection, ending: Never, depth };
        let world = stage.world();
        // ANCHOR: narrow
        match world.matte(plan) {
            Some(matte) => shot.draw(&matte, plan, settings),
            None => shot.draw(&world, plan, settings),
        }
        // ANCHOR_END: narrow
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }
}

#[cfg(test)]
mod tests {
    use common::chapter::Asked;
    use common::plan::Simulate;
    use common::render::{Rendering, Settings};
    use common::tally::Counts;

    use super::PathTracing;
    use crate::tracer::{BOUNCES, LAMPS_MET, SKY_SEEN, SPECULAR_BOUNCES, TRUNCATED_PATHS};

    fn drawn(scene: &str, options: &str, simulate: Simulate, threads: usize) -> Rendering<Counts> {
        let settings = Settings { width: 64, height: 48, spp: 4, threads, ..Settings::default() };
        let asked = Asked { scene, options, simulate };
        asked.draw::<PathTracing>(&settings).expect("a picture")
    }

    #[test]
    fn what_is_not_called_for_changes_no_bit_and_is_not_done() {
        let skipped = [
            ("cornell", &[SKY_SEEN, SPECULAR_BOUNCES][..]),
            ("cornell-glass", &[SKY_SEEN][..]),
            ("bunny", &[LAMPS_MET, SPECULAR_BOUNCES][..]),
            ("dark", &[LAMPS_MET, SKY_SEEN, SPECULAR_BOUNCES, BOUNCES][..]),
            ("empty", &[LAMPS_MET, SKY_SEEN, BOUNCES][..]),
        ];
        for (name, events) in skipped {
            let needed = drawn(name, "", Simulate::Needed, 1);
            let all = drawn(name, "", Simulate::All, 3);
            assert_eq!(needed.film.hash(), all.film.hash(), "{name}");
            assert_eq!(needed.film.nonfinite, 0, "{name}");
            for event in events {
                assert_eq!(needed.tally.of(*event), 0, "{name}: {}", event.name());
            }
        }
    }

    #[test]
    fn every_pixel_of_a_furnace_is_the_same() {
        for name in ["furnace", "furnace-ball"] {
            let film = drawn(name, "--albedo 0.5 --depth 30", Simulate::Needed, 0).film;
            let wrong =
                film.pixels.iter().filter(|pixel| (**pixel - 2.0).abs().max_element() > 1e-5);
            assert_eq!(wrong.count(), 0, "{name}");
        }
    }

    #[test]
    fn without_depth_only_lamps_are_seen() {
        let film = drawn("cornell", "--depth 0", Simulate::Needed, 0);
        assert_eq!(film.tally.of(BOUNCES), 0);
        assert!(film.tally.of(LAMPS_MET) > 0 && film.tally.of(TRUNCATED_PATHS) > 0);
        assert!(film.film.pixels.iter().any(|pixel| pixel.x > 40.0));
    }

    #[test]
    fn no_light_is_black_and_an_eye_in_a_wall_is_no_error() {
        let dark = drawn("dark", "", Simulate::All, 0).film;
        assert!(dark.pixels.iter().all(|pixel| pixel.max_element() == 0.0));
        let inside = "--eye 278,273,559.2 --look-at 278,273,600";
        assert_eq!(drawn("cornell", inside, Simulate::Needed, 0).film.nonfinite, 0);
        let inside = "--eye 185,80,169 --look-at 186,80,100";
        assert_eq!(drawn("cornell-glass", inside, Simulate::Needed, 0).film.nonfinite, 0);
    }

    #[test]
    fn what_can_t_be_is_refused_and_not_drawn() {
        let refused = |scene, options| {
            let asked = Asked { options, ..Asked::of(scene) };
            asked.draw::<PathTracing>(&Settings::default()).is_err()
        };
        assert!(refused("nowhere", "") && refused("cornell", "--depth -1"));
        assert!(refused("cornell", "--sideways") && refused("furnace", "--albedo 2"));
    }
}
