use std::sync::Arc;

use common::film::Color;
use common::plan::{Plan, Simulate};
use common::render::{Rendering, Settings, Watch};
use common::tally::{Counts, Event, Off};
use glam::Vec3;
use light_sampling::by_light::{ByLight, LIGHT_SAMPLES};
use light_sampling::lamp::Way;
use light_sampling::lights::{Choice, Lights};
use light_sampling::scenes::named;
use path_tracing::lambert::Lambert;
use path_tracing::model::Model;
use path_tracing::part::{Form, Part};
use path_tracing::shot::Shot;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::tracer::{BOUNCES, LAMPS_MET, LONGEST_PATH, TRUNCATED_PATHS};
use path_tracing::world::World;
use pulp::NullaryFnOnce;
use ray_casting::camera::CAMERA_RAYS;
use shadows::visibility::{BLOCKED_RAYS, SHADOW_RAYS};

use super::{Abreast, Batch, Start};
use crate::ending::Rule;
use crate::naive::Report;
use crate::roulette::{Constant, Roulette};

const EVENTS: [Event; 8] = [
    CAMERA_RAYS,
    BOUNCES,
    LIGHT_SAMPLES,
    SHADOW_RAYS,
    BLOCKED_RAYS,
    LAMPS_MET,
    TRUNCATED_PATHS,
    LONGEST_PATH,
];

const RULE: Rule = Rule::Throughput(Roulette { threshold: 0.5 });

fn stage(model: &Model<Smooth>) -> Stage<Smooth> {
    Stage::new(model).expect("sound")
}

fn cornell() -> Stage<Smooth> {
    stage(&named("cornell", 0.5).expect("a scene"))
}

fn matte<'a>(stage: &'a Stage<Smooth>) -> World<'a, Lambert> {
    stage.world().narrowed(Smooth::lambert).expect("matte")
}

fn lights(world: &World<Lambert>) -> Lights {
    Lights::new(world.space, &world.surfaces, Choice::Power, Way::Area)
}

/// The picture by sixteen paths at once; `None` if the scene isn't one for that.
fn abreast(
    stage: &Stage<Smooth>,
    rule: (Rule, u32),
    settings: &Settings,
) -> Option<Rendering<Counts>> {
    let world = matte(stage);
    let lights = lights(&world);
    Some(Abreast::new(&world, &stage.camera, &lights, rule, settings)?.draw())
}

/// The same by one path after the other: chapter 12's program.
fn alone(stage: &Stage<Smooth>, rule: (Rule, u32), settings: &Settings) -> Rendering<Counts> {
    let world = matte(stage);
    let lights = lights(&world);
    let (ending, depth) = rule;
    let shot = Shot { camera: &stage.camera, lighting: ByLight { lights: &lights }, ending, depth };
    let plan = Plan::new(&stage.calls, path_tracing::command::SKILLS, Simulate::Needed);
    shot.draw(&world, &plan, settings)
}

#[track_caller]
fn same(stage: &Stage<Smooth>, rule: (Rule, u32), settings: &Settings) {
    let found = abreast(stage, rule, settings).expect("a few matte triangles");
    let expected = alone(stage, rule, settings);
    assert_eq!(found.film, expected.film, "{settings:?}");
    for event in EVENTS {
        let name = event.name();
        assert_eq!(found.tally.of(event), expected.tally.of(event), "{name}, {settings:?}");
    }
}

fn settings(width: u32, height: u32, spp: u32) -> Settings {
    Settings { width, height, spp, seed: 14, threads: 1, ..Settings::default() }
}

#[test]
fn the_same_bits_as_one_path_after_another() {
    let stage = cornell();
    for (width, height, spp) in [(32, 32, 16), (1, 1, 1), (7, 13, 3), (40, 9, 1), (3, 2, 3000)] {
        same(&stage, (RULE, 1000), &settings(width, height, spp));
    }
    same(&stage, (RULE, 1000), &Settings { threads: 3, seed: 15, ..settings(50, 50, 4) });
}

#[test]
fn the_same_bits_however_paths_end() {
    let stage = cornell();
    let report = Rule::Report(Report { probability: 0.8 });
    for rule in [Rule::Constant(Constant::REPORT), report, Rule::Never] {
        same(&stage, (rule, 7), &settings(24, 24, 4));
    }
    same(&stage, (RULE, 1), &settings(24, 24, 4));
    same(&stage, (Rule::Throughput(Roulette { threshold: 2.0 }), 1000), &settings(24, 24, 4));
}

fn square(y: f32, side: f32) -> Form {
    let corner = |x: f32, z: f32| Vec3::new(side * x, y, side * z);
    Form::quad([corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)])
}

/// A lamp that shines to both sides, one that reflects as well, an open room, a triangle without area,
/// and paths that leave.
fn odd_room() -> Vec<Part<Smooth>> {
    let mut both = Part::glowing(square(1.5, 0.5), Smooth::matte(0.2, 0.3, 0.4), Color::ONE);
    both.emission.both_sides = true;
    let low =
        Part::glowing(square(-0.9, 0.4), Smooth::matte(0.1, 0.1, 0.1), Color::new(0.7, 0.5, 0.3));
    let line = Form::Triangles(vec![[Vec3::ZERO, Vec3::X, 2.0 * Vec3::X]]);
    vec![
        Part::dark(square(-1.0, 2.0), Smooth::matte(0.9, 0.6, 0.0)),
        Part::dark(line, Smooth::matte(0.5, 0.5, 0.5)),
        both,
        low,
        Part::dark(square(2.5, 3.0), Smooth::matte(0.8, 0.8, 0.8)),
    ]
}

fn odd(parts: Vec<Part<Smooth>>) -> Stage<Smooth> {
    let mut view = named("cornell", 0.5).expect("a scene").view;
    (view.eye, view.target) = (Vec3::new(0.3, 0.8, 5.0), Vec3::ZERO);
    stage(&Model::new(parts, Color::ZERO, view))
}

#[test]
fn the_same_bits_in_an_odd_room() {
    let stage = odd(odd_room());
    assert_eq!(lights(&matte(&stage)).left_out(), 0);
    same(&stage, (RULE, 1000), &settings(40, 40, 9));
    same(&stage, (Rule::Never, 50), &settings(20, 20, 9));
}

/// Next to a glare that shines away from all, the room's own lamps are too faint to be looked at. Their
/// light counts where paths come upon them, at any bounce.
#[test]
fn the_same_bits_of_lamps_that_are_met_by_chance_alone() {
    let mut parts = odd_room();
    parts.push(Part::glowing(square(30.0, 1.0), Smooth::BLACK, Color::splat(1e9)));
    let stage = odd(parts);
    let world = matte(&stage);
    assert_eq!(lights(&world).left_out(), 4, "two lamps of two triangles");
    same(&stage, (RULE, 1000), &settings(40, 40, 9));
    let drawn = abreast(&stage, (RULE, 1000), &settings(40, 40, 9)).expect("matte triangles");
    let seen = abreast(&stage, (RULE, 0), &settings(40, 40, 9)).expect("matte triangles");
    let sum = |drawn: &Rendering<Counts>| drawn.film.tile_means(1, 1)[0].x;
    assert!(sum(&drawn) > 1.05 * sum(&seen), "more than what the eye sees of lamps");
}

/// What is compiled for the oldest processors gives the bits of what is compiled for this one.
#[test]
fn the_same_bits_with_vectors_of_any_width() {
    let (stage, settings) = (cornell(), settings(16, 16, 4));
    let world = matte(&stage);
    let lights = lights(&world);
    let abreast = Abreast::new(&world, &stage.camera, &lights, (RULE, 1000), &settings);
    let abreast = abreast.expect("a few matte triangles");
    let mut pictures = [(); 2].map(|()| vec![Color::ZERO; 16 * 16 * 4]);
    let [narrow, wide] = &mut pictures;
    Batch { abreast: &abreast, first: 0, colors: narrow, tally: &mut Off }.call();
    pulp::Arch::new().dispatch(Batch {
        abreast: &abreast,
        first: 0,
        colors: wide,
        tally: &mut Off,
    });
    assert_eq!(narrow, wide);
    assert!(narrow.iter().any(|color| *color != Color::ZERO));
}

#[test]
fn the_same_bits_whenever_paths_start() {
    let (stage, settings) = (cornell(), settings(16, 16, 4));
    let world = matte(&stage);
    let lights = lights(&world);
    let films = [Start::AtOnce, Start::Together].map(|start| {
        let abreast = Abreast::new(&world, &stage.camera, &lights, (RULE, 1000), &settings);
        let abreast = abreast.expect("a few matte triangles");
        abreast.starting(start).draw::<Off>().film
    });
    assert_eq!(films[0], films[1]);
}

#[test]
fn other_scenes_are_not_for_it() {
    let settings = settings(4, 4, 1);
    for name in ["sphere-light", "many-lights", "dark"] {
        let stage = stage(&named(name, 0.5).expect("a scene"));
        assert!(abreast(&stage, (RULE, 1000), &settings).is_none(), "{name}");
    }
}

struct Stopped;

impl Watch for Stopped {
    fn done(&self, _pixels: u64) {}

    fn stop(&self) -> bool {
        true
    }
}

#[test]
fn it_stops_when_it_is_told_to() {
    let settings = Settings { watch: Arc::new(Stopped), ..settings(20, 20, 100) };
    let drawn = abreast(&cornell(), (RULE, 1000), &settings).expect("a few matte triangles");
    assert!(!drawn.complete);
}
