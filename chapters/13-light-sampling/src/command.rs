//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use path_tracing::bsdf::Bsdf;
use path_tracing::command::SKILLS;
use path_tracing::shot::Shot;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::strategy::{ByDirection, Never};
use path_tracing::tracer::{
    BOUNCES, LAMPS_MET, LONGEST_PATH, SKY_SEEN, SPECULAR_BOUNCES, TRUNCATED_PATHS,
};
use path_tracing::world::World;
use ray_casting::camera::CAMERA_RAYS;
use shadows::visibility::{BLOCKED_RAYS, SHADOW_RAYS};
use triangles::brute::TRIANGLE_TESTS;

use crate::by_light::{ByLight, LIGHT_SAMPLES};
use crate::cost;
use crate::hard;
use crate::knobs::{Counting, Knobs, Options};
use crate::lights::Lights;
use crate::naive::{Counted, Rule};
use crate::scenes::{self, SCENES};

/// Chapter 13's program.
pub struct LightSampling;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<LightSampling>();

/// The work that light sampling counts.
pub const EVENTS: &[Event] = &[
    CAMERA_RAYS,
    BOUNCES,
    SPECULAR_BOUNCES,
    LIGHT_SAMPLES,
    SHADOW_RAYS,
    BLOCKED_RAYS,
    LAMPS_MET,
    SKY_SEEN,
    TRUNCATED_PATHS,
    LONGEST_PATH,
    TRIANGLE_TESTS,
];

impl Chapter for LightSampling {
    const ID: &'static str = "13-light-sampling";
    const ABOUT: &'static str = "Chapter 13: looking for light where it comes from";
    const DEFAULTS: Defaults = Defaults { scene: "cornell", width: 256, height: 256, spp: 16 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = EVENTS;

    type Knobs = Options;
    type Scene = Stage<Smooth>;

    fn build(name: &str, knobs: &Options) -> Result<Stage<Smooth>, Failure> {
        let path = &knobs.light.path;
        let mut model = scenes::named(name, path.albedo.0)?;
        path.aim.apply(&mut model.view);
        let mut stage = Stage::new(&model).map_err(|error| Failure::Usage(error.to_string()))?;
        stage.warnings.extend(too_faint(&stage, &knobs.light));
        Ok(stage)
    }

    fn warnings(stage: &Stage<Smooth>) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage<Smooth>, _knobs: &Options) -> Vec<Call> {
        stage.calls.clone()
    }

    fn draw<T: Tally>(
        stage: &Stage<Smooth>,
        plan: &Plan,
        settings: &Settings,
        knobs: &Options,
    ) -> Rendering<T> {
        let world = stage.world();
        match world.matte(plan) {
            Some(matte) => lit(&matte, stage, plan, settings, knobs),
            None => lit(&world, stage, plan, settings, knobs),
        }
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }
}

/// A word on lamps that are never looked at (hard case LS-11).
fn too_faint(stage: &Stage<Smooth>, knobs: &Knobs) -> Option<String> {
    let way = knobs.lighting.way()?;
    let count = Lights::new(&stage.space, &stage.surfaces, knobs.lamps.into(), way).left_out();
    let lamps = if count == 1 { "1 lamp has".into() } else { format!("{count} lamps have") };
    let because = "less than 2^-24 of all power: found by chance only";
    (count > 0).then(|| format!("{lamps} {because}"))
}

/// The picture, with light looked for as the options say.
fn lit<B: Bsdf, T: Tally>(
    world: &World<B>,
    stage: &Stage<Smooth>,
    plan: &Plan,
    settings: &Settings,
    knobs: &Options,
) -> Rendering<T> {
    let Options { met, light } = knobs;
    let way = light.lighting.way().filter(|_| plan.simulates(Effect::AreaLights));
    let Some(way) = way else {
        return shot(stage, knobs, ByDirection).draw(world, plan, settings);
    };
    let lights = Lights::new(world.space, &world.surfaces, light.lamps.into(), way);
    let lighting = ByLight { lights: &lights };
    let rule = match met {
        Counting::Once => return shot(stage, knobs, lighting).draw(world, plan, settings),
        Counting::Camera => Rule::OnlyFrom(stage.camera.eye()),
        Counting::Twice => Rule::Always,
    };
    shot(stage, knobs, Counted { lighting, rule }).draw(world, plan, settings)
}

/// How the scene is drawn with this way of looking for light.
fn shot<'a, L>(stage: &'a Stage<Smooth>, knobs: &Options, lighting: L) -> Shot<'a, L, Never> {
    Shot { camera: &stage.camera, lighting, ending: Never, depth: knobs.light.path.depth }
}

#[cfg(test)]
mod tests {
    use common::chapter::{Asked, knobs};
    use common::film::Color;
    use common::plan::Simulate;
    use common::render::{Rendering, Settings};
    use common::tally::Counts;
    use glam::Vec3;
    use path_tracing::part::{Form, Part};
    use path_tracing::smooth::Smooth;
    use path_tracing::stage::Stage;
    use path_tracing::tracer::{BOUNCES, LAMPS_MET, SKY_SEEN, SPECULAR_BOUNCES};
    use shadows::visibility::SHADOW_RAYS;

    use super::{LIGHT_SAMPLES, LightSampling, too_faint};
    use crate::scenes::named;

    fn drawn(scene: &str, options: &str, simulate: Simulate, threads: usize) -> Rendering<Counts> {
        let settings = Settings { width: 48, height: 36, spp: 4, threads, ..Settings::default() };
        let asked = Asked { scene, options, simulate };
        asked.draw::<LightSampling>(&settings).expect("a picture")
    }

    #[test]
    fn what_is_not_called_for_changes_no_bit_and_is_not_done() {
        let skipped = [
            ("cornell", &[SKY_SEEN, SPECULAR_BOUNCES][..]),
            ("cornell-glass", &[SKY_SEEN][..]),
            ("bunny", &[LAMPS_MET, LIGHT_SAMPLES, SHADOW_RAYS, SPECULAR_BOUNCES][..]),
            ("dark", &[LAMPS_MET, LIGHT_SAMPLES, SHADOW_RAYS, SKY_SEEN, BOUNCES][..]),
            ("empty", &[LAMPS_MET, LIGHT_SAMPLES, SHADOW_RAYS, SKY_SEEN, BOUNCES][..]),
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
    fn all_options_draw_without_a_number_that_is_none() {
        let ways = ["--lighting area", "--lighting solid-angle", "--lighting direction"];
        let others = ["--lamps uniform", "--met twice", "--met camera"];
        for options in ways.into_iter().chain(others) {
            for name in ["cornell-glass", "sphere-light", "many-lights", "furnace"] {
                let film = drawn(name, options, Simulate::Needed, 0).film;
                assert_eq!(film.nonfinite, 0, "{name}, {options}");
                assert!(film.pixels.iter().any(|pixel| pixel.max_element() > 0.0));
            }
        }
    }

    #[test]
    fn lamps_that_are_never_looked_at_are_reported() {
        let mut model = named("cornell", 0.5).expect("a scene");
        let stage = Stage::new(&model).expect("a scene");
        let knobs = knobs::<LightSampling>("").expect("no option").light;
        assert_eq!(too_faint(&stage, &knobs), None);
        let form = Form::ball(Vec3::splat(100.0), 1e-3);
        model.parts.push(Part::glowing(form, Smooth::BLACK, Color::splat(1e-6)));
        let stage = Stage::new(&model).expect("a scene");
        let text = too_faint(&stage, &knobs).expect("a faint lamp");
        assert!(text.starts_with("1 lamp has less than"), "{text}");
    }
}
