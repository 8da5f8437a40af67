//! PT-01: whatever ends a path, a furnace's radiance is 1 / (1 - albedo).

use common::film::Color;
use common::hard::Case;
use common::sampler::Sampler;
use common::stats::estimate::t_test;
use common::stats::running::Running;
use common::tally::Off;
use glam::Vec3;
use path_tracing::furnace;
use path_tracing::lambert::Lambert;
use path_tracing::part::Emission;
use path_tracing::space::Space;
use path_tracing::strategy::{ByDirection, Ending};
use path_tracing::tracer::PathTracer;
use path_tracing::world::{Surface, World};
use ray_casting::ray::Ray;

use super::CHAPTER;
use crate::ending::Rule;
use crate::naive::Report;
use crate::roulette::{Constant, Roulette};

/// PT-01: Student's t-test of many paths.
pub(super) const FURNACE: Case = Case {
    id: "PT-01",
    chapter: CHAPTER,
    input: "a furnace of albedo 0.5 to 0.999, roulette on: a t-test",
    most: 30,
    naive_fails: |trial| Room::new(trial).is_wrong(Report { probability: 0.8 }),
    robust_fails: |trial| {
        let room = Room::new(trial);
        room.is_wrong(room.rule)
    },
};

/// How seldom right code may be taken for wrong. Seeds are fixed, so a verdict never changes.
const SIGNIFICANCE: f64 = 1e-4;

/// A room, and a way to end paths in it.
struct Room {
    is_cube: bool,
    albedo: f32,
    paths: u64,
    rule: Rule,
    trial: u64,
}

impl Room {
    /// Five albedos, two shapes and three endings.
    fn new(trial: u64) -> Self {
        let (albedo, paths) = match trial % 5 {
            0 => (0.5, 100_000),
            1 => (0.8, 50_000),
            2 => (0.9, 30_000),
            3 => (0.99, 5_000),
            _ => (0.999, 1_000),
        };
        let rule = match trial / 10 {
            0 => Rule::Throughput(Roulette { threshold: 0.5 }),
            1 => Rule::Throughput(Roulette { threshold: 2.0 }),
            // Below the albedo's square the variance would be infinite, and no test could tell.
            _ => Constant::new(albedo).map_or(Rule::Never, Rule::Constant),
        };
        Self { is_cube: (trial / 5).is_multiple_of(2), albedo, paths, rule, trial }
    }

    fn is_wrong<E: Ending>(&self, ending: E) -> bool {
        let model =
            if self.is_cube { furnace::cube(self.albedo) } else { furnace::ball(self.albedo) };
        let space = Space::new(&model.parts);
        let bsdf = Lambert { reflectance: Color::splat(self.albedo) };
        let emission = Emission { radiance: Color::ONE, both_sides: true };
        let world =
            World { space: &space, surfaces: vec![Surface { bsdf, emission }], sky: Color::ZERO };
        let (lighting, depth) = (ByDirection, u32::MAX);
        let tracer = PathTracer::<_, _, _, true, false> { world: &world, lighting, ending, depth };

        let path = |path| {
            let sampler = Sampler::new(1410 + self.trial, path, 0, 1);
            f64::from(tracer.radiance(LOOK, &sampler, &mut Off).x)
        };
        let found: Running = (0..self.paths).map(path).collect();
        let expected = 1.0 / (1.0 - f64::from(self.albedo));
        !t_test(&found, expected).is_some_and(|test| test.p_value >= SIGNIFICANCE)
    }
}

/// From off the middle.
const LOOK: Ray = Ray { origin: Vec3::new(0.1, -0.2, 0.3), direction: Vec3::NEG_Z };
