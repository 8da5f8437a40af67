//! PT-05: in a closed white room no path ever ends by roulette.

use std::sync::LazyLock;

use common::film::Color;
use common::hard::{Case, UNLIMITED};
use common::sampler::{Sampler, Stream};
use common::tally::Counts;
use glam::Vec3;
use path_tracing::furnace;
use path_tracing::lambert::Lambert;
use path_tracing::part::Emission;
use path_tracing::space::Space;
use path_tracing::strategy::ByDirection;
use path_tracing::tracer::{PathTracer, TRUNCATED_PATHS};
use path_tracing::world::{Surface, World};
use ray_casting::ray::Ray;

use super::CHAPTER;
use crate::naive::textbook;
use crate::roulette::Roulette;

/// How long the roulette alone is watched.
const PATIENCE: u32 = 200;

static SPACE: LazyLock<Space> = LazyLock::new(|| Space::new(&furnace::cube(1.0).parts));

/// PT-05: the depth ends the path, which brings exactly 1 + depth and is counted.
pub(super) const ENDLESS: Case = Case {
    id: "PT-05",
    chapter: CHAPTER,
    input: "a closed white room: does the path end, and is it counted?",
    most: UNLIMITED,
    naive_fails: |trial| {
        let mut stream = Stream::of_trial(1405, trial);
        let mut throughput = Color::ONE;
        for _ in 0..PATIENCE {
            match textbook(throughput, stream.uniform()) {
                Some(factor) => throughput *= factor,
                None => return false,
            }
        }
        true
    },
    robust_fails: |trial| {
        let depth = 1 + (trial % 16) as u32;
        let emission = Emission { radiance: Color::ONE, both_sides: true };
        let white = Surface { bsdf: Lambert { reflectance: Color::ONE }, emission };
        let world = World { space: &SPACE, surfaces: vec![white], sky: Color::ZERO };
        let (lighting, ending) = (ByDirection, Roulette::default());
        let tracer = PathTracer::<_, _, _, true, false> { world: &world, lighting, ending, depth };
        let mut counts = Counts::default();
        let sampler = Sampler::new(1405, trial, 0, 1);
        let found = tracer.radiance(LOOK, &sampler, &mut counts);
        found != Color::splat(1.0 + depth as f32) || counts.of(TRUNCATED_PATHS) != 1
    },
};

/// From off the middle.
const LOOK: Ray = Ray { origin: Vec3::new(0.1, -0.2, 0.3), direction: Vec3::NEG_Z };
