//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use light_sampling::by_light::{ByLight, LIGHT_SAMPLES};
use light_sampling::lamp::Way;
use light_sampling::lights::Lights;
use light_sampling::scenes::{self, SCENES};
use path_tracing::bsdf::Bsdf;
use path_tracing::command::SKILLS;
use path_tracing::lambert::Lambert;
use path_tracing::shot::Shot;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::strategy::ByDirection;
use path_tracing::tracer::{
    BOUNCES, LAMPS_MET, LONGEST_PATH, SKY_SEEN, SPECULAR_BOUNCES, TRUNCATED_PATHS,
};
use path_tracing::world::World;
use ray_casting::camera::{CAMERA_RAYS, Camera};
use shadows::visibility::{BLOCKED_RAYS, SHADOW_RAYS};
use triangles::brute::TRIANGLE_TESTS;

use crate::abreast::Abreast;
use crate::ending::Rule;
use crate::knobs::{Knobs, Paths};
use crate::{cost, hard};

/// Chapter 14's program.
pub struct RussianRoulette;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<RussianRoulette>();

/// The work that this chapter counts.
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

impl Chapter for RussianRoulette {
    const ID: &'static str = "14-russian-roulette";
    const ABOUT: &'static str = "Chapter 14: paths that end by chance, and are right on average";
    const DEFAULTS: Defaults = Defaults { scene: "cornell", width: 256, height: 256, spp: 16 };
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
        let world = stage.world();
        match world.matte(plan) {
            Some(world) => matte(&world, &stage.camera, plan, settings, knobs),
            None => lit(&world, &stage.camera, plan, settings, knobs),
        }
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }
}

/// The picture of matte surfaces: by sixteen paths side by side where that is possible.
pub fn matte<T: Tally>(
    world: &World<Lambert>,
    camera: &Camera,
    plan: &Plan,
    settings: &Settings,
    knobs: &Knobs,
) -> Rendering<T> {
    abreast(world, camera, plan, settings, knobs)
        .unwrap_or_else(|| lit(world, camera, plan, settings, knobs))
}

/// The picture by sixteen paths side by side. `None` if the scene, the plan or the options ask for more
/// than matte triangles, lit by lamps that are looked for by their area.
fn abreast<T: Tally>(
    world: &World<Lambert>,
    camera: &Camera,
    plan: &Plan,
    settings: &Settings,
    knobs: &Knobs,
) -> Option<Rendering<T>> {
    let simple = plan.simulates(Effect::AreaLights)
        && plan.simulates(Effect::IndirectLight)
        && !plan.simulates(Effect::EnvironmentLight)
        && knobs.paths == Paths::Abreast;
    let way = knobs.lighting.way().filter(|way| simple && *way == Way::Area)?;
    let lights = Lights::new(world.space, &world.surfaces, knobs.lamps.into(), way);
    let depth = knobs.depth;
    Some(match knobs.rule() {
        Rule::Throughput(roulette) => {
            Abreast::new(world, camera, &lights, (roulette, depth), settings)?.draw()
        }
        rule => Abreast::new(world, camera, &lights, (rule, depth), settings)?.draw(),
    })
}

/// The picture of any materials, with light looked for and paths ended as the options say.
pub fn lit<B: Bsdf, T: Tally>(
    world: &World<B>,
    camera: &Camera,
    plan: &Plan,
    settings: &Settings,
    knobs: &Knobs,
) -> Rendering<T> {
    let (ending, depth) = (knobs.rule(), knobs.depth);
    match knobs.lighting.way().filter(|_| plan.simulates(Effect::AreaLights)) {
        Some(way) => {
            let lights = Lights::new(world.space, &world.surfaces, knobs.lamps.into(), way);
            let lighting = ByLight { lights: &lights };
            Shot { camera, lighting, ending, depth }.draw(world, plan, settings)
        }
        None => Shot { camera, lighting: ByDirection, ending, depth }.draw(world, plan, settings),
    }
}

#[cfg(test)]
mod tests {
    use common::chapter::Asked;
    use common::film::Film;
    use common::plan::Simulate;
    use common::render::{Rendering, Settings};
    use common::tally::Counts;
    use path_tracing::tracer::{LONGEST_PATH, SPECULAR_BOUNCES, TRUNCATED_PATHS};

    use super::RussianRoulette;

    fn draw(scene: &str, options: &str, spp: u32, simulate: Simulate) -> Rendering<Counts> {
        let settings = Settings { width: 24, height: 24, spp, ..Settings::default() };
        let asked = Asked { scene, options, simulate };
        asked.draw::<RussianRoulette>(&settings).expect("a picture")
    }

    fn mean(film: &Film) -> f32 {
        film.tile_means(1, 1)[0].y
    }

    #[test]
    fn a_picture_of_all_effects_is_the_same() {
        let [needed, all] =
            [Simulate::Needed, Simulate::All].map(|simulate| draw("cornell", "", 2, simulate));
        assert_eq!(needed.film.hash(), all.film.hash());
        assert_eq!(needed.tally.of(SPECULAR_BOUNCES), 0);
    }

    #[test]
    fn right_endings_agree_and_the_report_s_line_does_not() {
        let mean = |roulette: &str| {
            let options = format!("--roulette {roulette}");
            mean(&draw("cornell", &options, 64, Simulate::Needed).film)
        };
        let all = mean("off");
        for roulette in ["throughput", "constant", "0.6"] {
            assert!((mean(roulette) / all - 1.0).abs() < 0.05, "{roulette}");
        }
        assert!(mean("report") < 0.87 * all, "most of the indirect light is missing");
    }

    #[test]
    fn the_report_s_line_is_right_at_one_half() {
        let [report, all] = ["--roulette report --survival 0.5", "--roulette off"]
            .map(|options| mean(&draw("cornell", options, 64, Simulate::Needed).film));
        assert!((report / all - 1.0).abs() < 0.05, "{report} {all}");
    }

    #[test]
    fn a_white_room_is_cut_off_and_says_so() {
        let options = "--albedo 1 --depth 30 --lighting direction";
        let white = draw("furnace", options, 1, Simulate::Needed);
        assert_eq!(white.tally.of(TRUNCATED_PATHS), 24 * 24);
        assert_eq!(white.tally.of(LONGEST_PATH), 30);
        assert_eq!(mean(&white.film), 31.0);
    }

    #[test]
    fn nothing_is_cut_off_in_the_box() {
        let tally = draw("cornell", "", 16, Simulate::Needed).tally;
        assert_eq!(tally.of(TRUNCATED_PATHS), 0);
        assert!(tally.of(LONGEST_PATH) > 8);
    }
}
