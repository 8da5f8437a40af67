//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::film::Film;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use path_tracing::stage::Stage;
use russian_roulette::command::{EVENTS, lit, matte};

use crate::finish::{Finish, Narrowest};
use crate::knobs::Knobs;
use crate::scenes::{self, SCENES};
use crate::{cost, hard};

/// Chapter 15's program.
pub struct Microfacets;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Microfacets>();

/// The effects this chapter can simulate.
pub const SKILLS: &[Skill] = &[
    Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
    Skill { effect: Effect::AreaLights, unless: "nothing glows" },
    Skill { effect: Effect::IndirectLight, unless: "no surface sends light on" },
    Skill { effect: Effect::MirrorReflection, unless: "nothing is a mirror" },
    Skill { effect: Effect::Refraction, unless: "nothing is clear glass" },
    Skill { effect: Effect::GlossyReflection, unless: "no metal and no glass is rough" },
    Skill { effect: Effect::EnvironmentLight, unless: "all around is black" },
];

impl Chapter for Microfacets {
    const ID: &'static str = "15-microfacets";
    const ABOUT: &'static str = "Chapter 15: rough metal and rough glass";
    const DEFAULTS: Defaults = Defaults { scene: "polish", width: 640, height: 400, spp: 16 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = SKILLS;
    const EVENTS: &'static [Event] = EVENTS;

    type Knobs = Knobs;
    type Scene = Stage<Finish>;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage<Finish>, Failure> {
        let path = &knobs.path;
        let mut model = scenes::named(name, path.albedo.0)?;
        path.aim.apply(&mut model.view);
        let model = model.map(|finish| finish.with_facets(|facets| knobs.apply(facets)));
        Stage::new(&model).map_err(|error| Failure::Usage(error.to_string()))
    }

    fn warnings(stage: &Stage<Finish>) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage<Finish>, _knobs: &Knobs) -> Vec<Call> {
        stage.calls.clone()
    }

    fn draw<T: Tally>(
        stage: &Stage<Finish>,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let (camera, path) = (&stage.camera, &knobs.path);
        match Narrowest::new(stage.world(), plan) {
            Narrowest::Matte(world) => matte(&world, camera, plan, settings, path),
            Narrowest::Smooth(world) => lit(&world, camera, plan, settings, path),
            Narrowest::Finish(world) => lit(&world, camera, plan, settings, path),
        }
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

#[cfg(test)]
mod tests {
    use common::chapter::Asked;
    use common::film::{Color, Film};
    use common::plan::Simulate;
    use common::render::{Rendering, Settings};
    use common::tally::Counts;
    use path_tracing::tracer::SPECULAR_BOUNCES;

    use super::Microfacets;
    use crate::albedo::roughest;
    use crate::facets::Masking;
    use crate::scenes::SCENES;

    fn draw(scene: &str, options: &str, spp: u32, simulate: Simulate) -> Rendering<Counts> {
        let settings = Settings { width: 24, height: 24, spp, ..Settings::default() };
        let asked = Asked { scene, options, simulate };
        asked.draw::<Microfacets>(&settings).expect("a picture")
    }

    fn mean(film: &Film) -> f32 {
        film.tile_means(1, 1)[0].y
    }

    #[test]
    fn a_picture_of_all_effects_is_the_same() {
        for scene in SCENES.iter().filter(|scene| scene.name != "FILE.obj") {
            let [needed, all] =
                [Simulate::Needed, Simulate::All].map(|simulate| draw(scene.name, "", 1, simulate));
            assert_eq!(needed.film.hash(), all.film.hash(), "{}", scene.name);
        }
        let matte = draw("cornell", "", 1, Simulate::Needed);
        assert_eq!(matte.tally.of(SPECULAR_BOUNCES), 0);
    }

    #[test]
    fn both_choices_of_normals_make_the_same_picture() {
        let of = |normals| {
            let options = format!("--normals {normals} --roughness 0.5");
            mean(&draw("rough-metals", &options, 64, Simulate::Needed).film)
        };
        let (visible, all) = (of("visible"), of("all"));
        assert!((visible / all - 1.0).abs() < 0.02, "{visible} {all}");
    }

    #[test]
    fn by_light_and_by_direction_agree_on_rough_metal() {
        let of = |lighting, spp| {
            let options = format!("--lighting {lighting} --roughness 0.6");
            mean(&draw("rough-metals", &options, spp, Simulate::Needed).film)
        };
        let (light, direction) = (of("area", 64), of("direction", 1024));
        assert!((light / direction - 1.0).abs() < 0.05, "{light} {direction}");
    }

    #[test]
    fn in_the_middle_of_a_rough_ball_1_minus_ln_2_is_left() {
        let options = "--roughness 1 --eye 0,1.3,9 --look-at 0,1.3,0 --fov 0.5";
        let found = mean(&draw("lost-light", options, 64, Simulate::Needed).film);
        let closed = roughest(1.0, Masking::Correlated) as f32;
        assert!((found - closed).abs() < 0.01, "{found} {closed}");
    }

    #[test]
    fn a_perfectly_smooth_ball_loses_nothing() {
        let film = draw("lost-light", "--roughness 0", 4, Simulate::Needed).film;
        assert!((mean(&film) - 1.0).abs() < 1e-5);
    }

    /// The means of 4x4 tiles by Mitsuba 3.9.1; see `tests/reference/README.md`.
    const REFERENCE: &str = include_str!("../../../tests/reference/rough-metals.csv");

    #[test]
    fn another_renderer_makes_the_same_picture() {
        let settings = Settings { width: 32, height: 32, spp: 512, ..Settings::default() };
        let asked = Asked::of("rough-metals");
        let film = asked.draw::<Microfacets>(&settings).expect("a picture").film;
        let tiles = REFERENCE.lines().filter(|line| line.starts_with(|it: char| it.is_numeric()));
        let (mut ours, mut theirs) = (0.0, 0.0);
        for (tile, line) in film.tile_means(4, 4).into_iter().zip(tiles) {
            let numbers: Vec<f32> = line.split(',').filter_map(|it| it.parse().ok()).collect();
            let reference = Color::from_slice(&numbers[2..5]);
            let (one, other) = (tile.element_sum(), reference.element_sum());
            assert!((one / other - 1.0).abs() < 0.05, "{line}: {tile}");
            (ours, theirs) = (ours + one, theirs + other);
        }
        assert!((ours / theirs - 1.0).abs() < 0.01, "{ours} {theirs}");
    }
}
