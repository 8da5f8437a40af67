//! Light that is known exactly, and paths by other means.

use common::film::Color;
use common::sampler::Sampler;
use common::stats::estimate::{Estimate, z_test};
use common::stats::running::Running;
use common::tally::{Counts, Off};
use fresnel::index::Index;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::{
    BOUNCES, LAMPS_MET, LONGEST_PATH, PathTracer, SKY_SEEN, SPECULAR_BOUNCES, TRUNCATED_PATHS,
};
use crate::bsdf::Bsdf;
use crate::furnace;
use crate::glass::Glass;
use crate::mirror::Mirror;
use crate::model::Model;
use crate::part::{Form, Part};
use crate::random::Random;
use crate::smooth::Smooth;
use crate::stage::Stage;
use crate::strategy::{ByDirection, Ending, Lighting, Never};
use crate::world::World;

type Tracer<'a, B> = PathTracer<'a, B, ByDirection, Never, true, true>;

fn tracer<'a, B>(world: &'a World<'a, B>, depth: u32) -> Tracer<'a, B> {
    PathTracer { world, lighting: ByDirection, ending: Never, depth }
}

fn stage(model: &Model<Smooth>) -> Stage<Smooth> {
    Stage::new(model).expect("sound")
}

fn sampler(trial: u64) -> Sampler {
    Sampler::new(1230, trial, 0, 1)
}

/// From inside any of the rooms.
fn look(trial: u64) -> Ray {
    let eye = Vec3::new(0.1, -0.2, 0.3);
    let turn = trial as f32;
    let to = Vec3::new(turn % 7.0 - 3.0, turn % 5.0 - 2.0, turn % 3.0 - 1.25);
    Ray { origin: eye, direction: to.normalize() }
}

/// The mean of many paths, each a trial of its own.
fn estimate<B: Bsdf, L: Lighting, E: Ending, const EMITTERS: bool, const SKY: bool>(
    tracer: &PathTracer<B, L, E, EMITTERS, SKY>,
    ray: Ray,
) -> Estimate {
    let path = |trial| f64::from(tracer.radiance(ray, &sampler(trial), &mut Off).y);
    let samples: Running = (0..20_000).map(path).collect();
    Estimate::of(&samples).expect("many")
}

fn assert_agrees(estimate: &Estimate, right: f64) {
    let test = z_test(estimate, &Estimate::exact(right));
    assert!(test.p_value > 1e-5, "{estimate:?} is not {right}: {test:?}");
}

#[test]
fn every_path_in_a_furnace_brings_the_same() {
    for albedo in [0.0, 0.5, 0.9, 0.99, 1.0] {
        for model in [furnace::cube(albedo), furnace::ball(albedo)] {
            let stage = stage(&model);
            let world = stage.world();
            for depth in [0, 1, 2, 10, 100] {
                let right = furnace::radiance(f64::from(albedo), depth);
                for trial in 0..20 {
                    let found =
                        tracer(&world, depth).radiance(look(trial), &sampler(trial), &mut Off);
                    assert!((f64::from(found.x) - right).abs() < 1e-5 * right, "{found} {right}");
                }
            }
        }
    }
}

#[test]
fn the_shell_s_wall_has_its_radiance() {
    let ray = Ray { origin: Vec3::new(1.5, 0.25, -0.125), direction: Vec3::X };
    for albedo in [0.3, 0.8] {
        let stage = stage(&furnace::shell(albedo));
        let world = stage.world();
        for depth in [1, 2, 5] {
            let found = estimate(&tracer(&world, depth), ray);
            assert_agrees(&found, furnace::shell_radiance(f64::from(albedo), depth));
        }
    }
}

#[test]
fn glass_and_mirrors_can_t_be_seen_in_a_furnace() {
    // Black walls that emit 1: whatever a clear thing does with light, it brings 1.
    let mut model = furnace::cube(0.0);
    let ball = |x, material| Part::dark(Form::ball(Vec3::new(x, 0.1, 0.0), 0.4), material);
    model.parts.push(ball(-0.5, Smooth::Glass(Glass { index: Index::GLASS })));
    model.parts.push(ball(0.5, Smooth::Mirror(Mirror { reflectance: Color::ONE })));
    let stage = stage(&model);
    let world = stage.world();
    let mut counts = Counts::default();
    for trial in 0..2000 {
        let origin = Vec3::new(0.0, 0.0, 0.9);
        let to = Vec3::new(if trial % 2 == 0 { -0.5 } else { 0.45 }, 0.02, 0.1);
        let ray = Ray { origin, direction: (to - origin).normalize() };
        let found = tracer(&world, 200).radiance(ray, &sampler(trial), &mut counts);
        assert_eq!(found, Color::ONE);
    }
    assert!(counts.of(SPECULAR_BOUNCES) > 2000, "{}", counts.of(SPECULAR_BOUNCES));
    assert_eq!(counts.of(SPECULAR_BOUNCES), counts.of(BOUNCES));
}

#[test]
fn what_is_done_is_counted() {
    let stage = stage(&furnace::cube(0.5));
    let world = stage.world();
    let mut counts = Counts::default();
    tracer(&world, 7).radiance(look(1), &sampler(1), &mut counts);
    let of = |event| counts.of(event);
    assert_eq!([of(BOUNCES), of(LAMPS_MET), of(LONGEST_PATH), of(TRUNCATED_PATHS)], [7, 8, 7, 1]);
    assert_eq!([of(SKY_SEEN), of(SPECULAR_BOUNCES)], [0, 0]);
}

#[test]
fn the_sky_is_seen_from_where_nothing_is_in_the_way() {
    let sky = Color::new(0.5, 1.0, 2.0);
    let floor = [[-1e3, -1e3], [-1e3, 1e3], [1e3, 1e3], [1e3, -1e3]];
    let floor = Form::quad(floor.map(|[x, z]| Vec3::new(x, 0.0, z)));
    let parts = vec![Part::dark(floor, Smooth::matte(0.5, 0.25, 0.125))];
    let stage = stage(&Model { parts, sky, ..furnace::ball(0.5) });
    let world = stage.world();
    let ray = Ray { origin: Vec3::new(0.0, 1.0, 0.0), direction: Vec3::NEG_Y };
    let mut counts = Counts::default();
    // Under an even sky a floor shows its albedo times the sky, in every path.
    for trial in 0..100 {
        let found = tracer(&world, 3).radiance(ray, &sampler(trial), &mut counts);
        assert_eq!(found, Color::new(0.25, 0.25, 0.25));
    }
    let up = Ray { direction: Vec3::Y, ..ray };
    assert_eq!(tracer(&world, 0).radiance(up, &sampler(0), &mut counts), sky);
    assert_eq!(counts.of(SKY_SEEN), 101);
}

/// Ends half of all paths, and lets the other half count double.
struct Coin;

impl Ending for Coin {
    fn factor(&self, _throughput: Color, _bounce: u32, random: &Random) -> Option<f32> {
        const COIN: common::sampler::Purpose = common::sampler::Purpose::named("test coin");
        (random.number(COIN) < 0.5).then_some(2.0)
    }
}

#[test]
fn an_ending_changes_no_mean() {
    let stage = stage(&furnace::shell(0.8));
    let world = stage.world();
    let ray = Ray { origin: Vec3::new(1.5, 0.25, -0.125), direction: Vec3::X };
    let tracer: PathTracer<_, _, _, true, false> =
        PathTracer { world: &world, lighting: ByDirection, ending: Coin, depth: 30 };
    assert_agrees(&estimate(&tracer, ray), furnace::shell_radiance(0.8, 30));
}

#[test]
fn a_long_path_stays_finite() {
    // 0.5^n is denormal from 127 surfaces on, and 0 from 150: the path ends there by itself.
    let stage = stage(&furnace::ball(0.5));
    let world = stage.world();
    let mut counts = Counts::default();
    let found = tracer(&world, 1000).radiance(look(1), &sampler(1), &mut counts);
    assert_eq!(found, Color::splat(2.0));
    assert!((149..=151).contains(&counts.of(BOUNCES)), "{}", counts.of(BOUNCES));
    assert_eq!(counts.of(TRUNCATED_PATHS), 0);
}
