//! What light does, checked by energy: furnaces, and media that are not there.

use blinn_phong::scenes::brute_force;
use common::film::{Color, Film};
use common::plan::{Effect, Plan, Simulate};
use common::render::Settings;
use common::tally::{Counts, Off, Tally};
use glam::Vec3;
use ray_casting::camera::View;
use whitted::limits::{Limits, STOPPED_BY_CUTOFF};

use whitted::mirror::MIRROR_RAYS;

use super::{REFLECTED, REFRACTED, TOTAL_REFLECTIONS};
use crate::command::SKILLS;
use crate::dielectric::reflectance;
use crate::index::Index;
use crate::interface::Interface;
use crate::path::{Branching, Formula};
use crate::picture::Picture;
use crate::scenes::Stage;

const SETTINGS: fn() -> Settings = || Settings { width: 80, height: 60, ..Settings::default() };

fn stage(name: &str, index: f32) -> Stage {
    let index = Index::new(index).expect("an index");
    Stage::named(name, brute_force, index, |_| ()).unwrap_or_else(|error| panic!("{error}"))
}

fn picture(stage: &Stage) -> Picture<'_> {
    let limits = Limits { depth: 5, cutoff: 0.0 };
    Picture { stage, formula: Formula::Exact, branching: Branching::Both, limits }
}

fn draw<T: Tally>(picture: &Picture, simulate: Simulate, settings: &Settings) -> (Film, T) {
    let plan = Plan::new(&picture.stage.calls, SKILLS, simulate);
    let made = picture.draw::<T>(&plan, settings);
    assert_eq!(made.film.nonfinite, 0);
    (made.film, made.tally)
}

/// "Index 1 is invisible to the bit": the same picture as without the ball, its shadow included.
#[test]
fn glass_of_index_1_is_not_there() {
    let with = stage("whitted", 1.0);
    let mut without = stage("whitted", 1.0);
    without.scene.objects.remove(1);
    let settings = Settings { width: 320, height: 240, ..Settings::default() };
    let (seen, counts) = draw::<Counts>(&picture(&with), Simulate::Needed, &settings);
    let (truth, _) = draw::<Off>(&picture(&without), Simulate::All, &settings);
    assert_eq!(seen.hash(), truth.hash());
    assert_eq!((counts.of(REFLECTED), counts.of(REFRACTED)), (0, 0));
    let glass = stage("whitted", 1.000_000_1);
    let (glass, _) = draw::<Off>(&picture(&glass), Simulate::Needed, &settings);
    assert_ne!(glass.hash(), truth.hash(), "the control");
}

/// Every way to follow light finds the radiance that is everywhere. What cut-off takes away is at
/// most the cut-off for each branch that it stops.
#[test]
fn in_a_furnace_glass_can_not_be_seen() {
    let mut stage = stage("nested", 1.5);
    stage.scene.objects.truncate(6);
    let background = stage.scene.background;
    for formula in [Formula::Exact, Formula::Schlick] {
        for (branching, cutoff) in [(Branching::Both, 1e-4), (Branching::One, 0.0)] {
            let limits = Limits { depth: 200, cutoff };
            let picture = Picture { formula, branching, limits, ..picture(&stage) };
            let (film, counts) = draw::<Counts>(&picture, Simulate::Needed, &SETTINGS());
            let mut lost = 0.0;
            for pixel in &film.pixels {
                let part = *pixel / background;
                assert!(part.max_element() < 1.000_01, "{branching:?} {part}");
                lost += 1.0 - part.min_element();
            }
            let stopped = counts.of(STOPPED_BY_CUTOFF) as f32 * cutoff;
            assert!(lost <= stopped + 1e-6 * 4800.0, "{branching:?} {lost} {stopped}");
        }
    }
}

/// Straight up out of water: the sky counts n² times, but for what the surface reflects.
#[test]
fn the_sky_is_brighter_under_water() {
    let up = |view: &mut View| {
        let eye = Vec3::new(0.3, -1.0, 0.2);
        *view = View { eye, target: eye + Vec3::Y, up: Vec3::Z, vertical_fov: 1.0 };
    };
    let mut stage = Stage::named("pool", brute_force, Index::GLASS, up).expect("a view");
    stage.scene.lights.clear();
    stage.scene.ambient = Color::ZERO;
    stage.scene.objects.truncate(2);
    let settings = Settings { width: 1, height: 1, ..Settings::default() };
    let (film, _) = draw::<Off>(&picture(&stage), Simulate::All, &settings);
    let water = Index::WATER.number();
    let reflected = reflectance(&Interface::new(Index::WATER, Index::AIR), 1.0);
    let expected = (1.0 - reflected) * water * water * stage.scene.background.as_dvec3();
    let error = (film.pixels[0].as_dvec3() - expected).abs().max_element();
    assert!(error < 1e-6, "{} {expected}", film.pixels[0]);
}

/// One ray by chance is right on average: 4000 samples of one pixel against both rays.
#[test]
fn one_way_by_chance_has_the_right_mean() {
    let stage = stage("nested", 1.5);
    let settings = Settings { width: 4, height: 3, ..Settings::default() };
    let limits = Limits { depth: 12, cutoff: 0.0 };
    let both = Picture { limits, ..picture(&stage) };
    let (truth, _) = draw::<Off>(&both, Simulate::Needed, &settings);
    let one = Picture { branching: Branching::One, ..both };
    let mut sums = [[0.0_f64; 2]; 12];
    let rounds = 4000;
    for seed in 0..rounds {
        let settings = Settings { seed, threads: 1, ..settings.clone() };
        let (film, _) = draw::<Off>(&one, Simulate::Needed, &settings);
        for (sum, pixel) in sums.iter_mut().zip(&film.pixels) {
            let green = f64::from(pixel.y);
            *sum = [sum[0] + green, sum[1] + green * green];
        }
    }
    let n = rounds as f64;
    for (pixel, (&[sum, squares], truth)) in sums.iter().zip(&truth.pixels).enumerate() {
        let mean = sum / n;
        let error = ((squares / n - mean * mean).max(0.0) / n).sqrt();
        // 5 standard errors: one in 10⁶.
        let off = (mean - f64::from(truth.y)).abs();
        assert!(off <= 5.0 * error + 1e-5, "pixel {pixel}: {mean} {}", truth.y);
    }
}

#[test]
fn what_is_not_called_for_is_not_done_and_changes_no_bit() {
    for name in ["whitted", "dark", "pool", "nested", "metals", "two-lamps", "sphere:60", "empty"] {
        let stage = stage(name, 1.5);
        let (needed, counts) = draw::<Counts>(&picture(&stage), Simulate::Needed, &SETTINGS());
        let (all, _) = draw::<Off>(&picture(&stage), Simulate::All, &SETTINGS());
        assert_eq!(needed.hash(), all.hash(), "{name}");
        let called = |effect| stage.calls.iter().any(|call| call.effect == effect);
        if !called(Effect::Refraction) {
            let glass = [REFLECTED, REFRACTED, TOTAL_REFLECTIONS].map(|event| counts.of(event));
            assert_eq!(glass, [0; 3], "{name}");
        }
        if !called(Effect::MirrorReflection) {
            assert_eq!(counts.of(MIRROR_RAYS), 0, "{name}");
        }
    }
}
