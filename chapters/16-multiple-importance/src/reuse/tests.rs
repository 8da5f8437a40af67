use common::chapter::Asked;
use common::film::Color;
use common::plan::Simulate;
use common::render::{Rendering, Settings};
use common::stats::error::film_relative_mse;
use common::stats::estimate::welch_test;
use common::stats::running::Running;
use common::tally::Counts;
use glam::{Vec2, Vec3};
use light_sampling::lamp::Way;
use light_sampling::lights::{Choice, Lights};
use microfacets::finish::Finish;
use path_tracing::lambert::Lambert;
use path_tracing::space::{Met, Space};
use path_tracing::stage::Stage;
use path_tracing::vertex::Vertex;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;

use super::claim::{First, Source};
use super::{Division, REUSED_PATHS, Reuse};
use crate::combined::Combined;
use crate::command::MultipleImportance;
use crate::heuristic::Heuristic;
use crate::scenes::named;
use crate::tiles::{Runs, exposed_tiles, least_p_value, stage, tiles};

/// So often may right code be refused by one of these tests; the seeds are fixed.
const SIGNIFICANCE: f64 = 0.01;
/// No multiple of a block's side, so that some are cut off.
const RUNS: Runs = Runs { width: 28, height: 20, spp: 3, count: 60, depth: 3, seed: 1 };

fn scene(name: &str) -> Stage<Finish> {
    stage(&named(name, 0.5).expect("a scene"))
}

fn shared(stage: &Stage<Finish>, side: u32, division: Division, runs: &Runs) -> Vec<Running> {
    let lights = Lights::new(&stage.space, &stage.surfaces, Choice::Power, Way::SolidAngle);
    let combined = Combined { lights: &lights, heuristic: Heuristic::Power };
    exposed_tiles(stage, combined, &Reuse { side, division }, runs)
}

fn alone(stage: &Stage<Finish>, runs: &Runs) -> Vec<Running> {
    let lights = Lights::new(&stage.space, &stage.surfaces, Choice::Power, Way::SolidAngle);
    tiles(stage, Combined { lights: &lights, heuristic: Heuristic::Power }, runs)
}

/// Matte walls; a mirror and glass; rough metal; a sky that paths leave for. Light that mirrors and
/// glass gather is rare: enough samples that their means are nearly normal.
#[test]
fn shared_paths_find_the_same_light() {
    for (name, spp) in [("cornell", 3), ("cornell-glass", 32), ("rough-metals", 16), ("bunny", 3)] {
        let stage = scene(name);
        let own = alone(&stage, &Runs { spp: 32.max(2 * spp), seed: 2, ..RUNS });
        for side in [2, 4, 8] {
            let runs = Runs { spp, ..RUNS };
            let p_value = least_p_value(&own, &shared(&stage, side, Division::Balance, &runs));
            assert!(p_value > SIGNIFICANCE, "{name}, {side}: {p_value}");
        }
    }
}

/// The power of the test above: even shares lose light where not all see the same, and 2 % more light is
/// found out.
#[test]
fn planted_errors_are_found() {
    let stage = scene("cornell");
    let own = alone(&stage, &Runs { spp: 32, count: 200, seed: 2, ..RUNS });
    let even = shared(&stage, 8, Division::Even, &Runs { count: 200, ..RUNS });
    assert!(least_p_value(&own, &even) < 1e-6);
    let right = shared(&stage, 8, Division::Balance, &Runs { count: 200, ..RUNS });
    assert!(least_p_value(&own, &right) > SIGNIFICANCE);
    let brighter = |tile: &Running| {
        let deviation = tile.variance().unwrap_or(0.0).sqrt();
        let step = |index: u64| if index.is_multiple_of(2) { deviation } else { -deviation };
        (0..tile.count()).map(|index| 1.02 * (tile.mean() + step(index))).collect()
    };
    let brighter: Vec<Running> = right.iter().map(brighter).collect();
    assert!(least_p_value(&own, &brighter) < 1e-6, "2 % more");
}

/// Inside a cube that glows everything has the radiance 1 + a + a² + a³, for paths of three bounces.
#[test]
fn a_furnace_shows_nothing() {
    let stage = scene("furnace");
    for tile in shared(&stage, 4, Division::Balance, &RUNS) {
        let error = tile.standard_error().expect("many");
        assert!(error < 5e-3, "{error}");
        assert!((tile.mean() - 1.875).abs() < 5.0 * error + 1e-5, "{tile:?}");
    }
}

fn drawn(options: &str, settings: &Settings) -> Rendering<Counts> {
    let asked = Asked { scene: "cornell", options, simulate: Simulate::Needed };
    asked.draw::<MultipleImportance>(settings).expect("a picture")
}

/// Paths that end early by chance are found by the same densities: the first surface lets all go on.
#[test]
fn roulette_takes_nothing_from_what_is_shared() {
    let means = |options| -> Running {
        let mean = |seed| {
            let settings = Settings { width: 16, height: 16, spp: 4, seed, ..Settings::default() };
            let sum: Color = drawn(options, &settings).film.pixels.iter().sum();
            f64::from(sum.element_sum())
        };
        (1..=200).map(mean).collect()
    };
    let [all, few] = ["--reuse 1 --threshold 0", "--reuse 4 --threshold 2"].map(means);
    let p_value = welch_test(&all, &few).expect("many").p_value;
    assert!(p_value > SIGNIFICANCE, "{p_value}");
}

/// What it is for: with the same number of paths, less than a quarter of the squared error.
#[test]
fn shared_paths_know_more() {
    let settings = Settings { width: 48, height: 48, spp: 4, ..Settings::default() };
    let truth = drawn("", &Settings { spp: 1024, seed: 2, ..settings.clone() });
    let error = |options| {
        film_relative_mse(&truth.film, &drawn(options, &settings).film).expect("one size")
    };
    let [own, shared] = ["--reuse 1", "--reuse 4"].map(error);
    assert!(shared < own / 4.0, "{shared} and {own}");
}

#[test]
fn a_film_of_any_size_is_the_same_on_any_number_of_threads() {
    for (width, height) in [(1, 1), (3, 9), (17, 6)] {
        let settings = Settings { width, height, spp: 3, threads: 1, ..Settings::default() };
        let more = Settings { threads: 3, ..settings.clone() };
        let [one, other] = [settings, more].map(|settings| drawn("--reuse 8", &settings));
        assert_eq!((&one.film, &one.tally), (&other.film, &other.tally));
        assert!(one.complete && one.film.nonfinite == 0);
    }
}

#[test]
fn paths_of_no_bounce_have_nothing_to_share() {
    let settings = Settings { width: 16, height: 16, spp: 3, ..Settings::default() };
    let shared = drawn("--reuse 4 --depth 0", &settings);
    assert_eq!(shared.film, drawn("--depth 0", &settings).film);
    assert_eq!(shared.tally.of(REUSED_PATHS), 0);
    assert!(drawn("--reuse 4", &settings).tally.of(REUSED_PATHS) > 0);
}

/// On a floor of albedo 0.5, as seen from above.
fn on_floor(x: f32) -> Met {
    let (point, normal) = (Vec3::new(x, 0.0, 0.0), Vec3::Y);
    let error = Vec3::splat(1e-6);
    let hit = Hit { t: 1.0, point, error, geometric: normal, normal, uv: Vec2::ZERO };
    Met { hit, piece: 0, owner: 0 }
}

/// A source of radiance 1 that looks down, found by the pixel at place 0.
fn source(point: Vec3) -> Source {
    let hit = Hit { point, geometric: Vec3::NEG_Y, normal: Vec3::NEG_Y, ..on_floor(0.0).hit };
    let (radiance, throughput) = (Color::ONE, Color::splat(0.5));
    Source { place: 0, hit, side: 1.0, radiance, throughput }
}

/// What two pixels get that see the floor at x = 0 and at `other`.
fn divided(source: &Source, other: f32, division: Division) -> [f32; 2] {
    let floor = Lambert::new(0.5, 0.5, 0.5);
    let mets = [0.0, other].map(on_floor);
    let down = Ray { origin: Vec3::Y, direction: Vec3::NEG_Y };
    let first = |place: usize| First { place, vertex: Vertex::new(&down, &mets[place], &floor) };
    let mut colors = [Color::ZERO; 2];
    let (firsts, empty) = ([first(0), first(1)], Space::new::<()>(&[]));
    source.divide(&empty, &firsts, division, &mut colors, &mut Counts::default());
    colors.map(|color| color.x)
}

/// *By hand:* one pixel's floor is straight below the source, the other's as far aside as the source is
/// high. The cosines are 1 and 1/√2, the squared distances 1 and 2, the densities 1/π and 1/(4 π): four
/// parts and one. Of 0.5, what the path is worth, 0.4 stay and 0.1 go to the neighbour.
#[test]
fn by_hand() {
    let [own, other] = divided(&source(Vec3::Y), 1.0, Division::Balance);
    assert!((own - 0.4).abs() < 1e-6 && (other - 0.1).abs() < 1e-6, "{own} and {other}");
    let far = divided(&source(1000.0 * Vec3::Y), 1.0, Division::Balance);
    assert!(far.iter().all(|part| (part - 0.25).abs() < 1e-3), "far away both see it alike");
}

/// Just above the neighbour's floor, found by a pixel farther away: even shares have no limit there.
#[test]
fn a_vertex_next_to_a_neighbour_counts_no_more_than_its_light() {
    let near = |height| source(Vec3::new(1.0, height, 0.0));
    let [own, other] = divided(&near(1e-3), 1.0, Division::Balance);
    assert!((own + other - 0.5).abs() < 1e-6 && own < 1e-6, "{own} and {other}");
    let [_, even] = divided(&near(1e-3), 1.0, Division::Even);
    assert!(even > 1e5, "{even}");
    let [_, even] = divided(&near(1e-6), 1.0, Division::Even);
    assert!(even > 1e10, "{even}");
}

/// In one place, behind, or where no distance can be told: the pixel that found it keeps it.
#[test]
fn what_cannot_be_measured_stays_whose_it_is() {
    let points = [Vec3::ZERO, Vec3::NAN, Vec3::NEG_Y, Vec3::splat(f32::INFINITY)];
    for (point, division) in points
        .into_iter()
        .flat_map(|point| [Division::Balance, Division::Even].map(|division| (point, division)))
    {
        assert_eq!(divided(&source(point), 1.0, division), [0.5, 0.0], "{point}");
    }
    let far = divided(&source(1e30 * Vec3::Y), 1e-30, Division::Balance);
    assert!(far.iter().all(|part| (part - 0.25).abs() < 1e-6), "{far:?}");
}
