//! PT-01: in a furnace every path must bring the same.

use std::sync::LazyLock;

use common::film::Color;
use common::hard::{Case, UNLIMITED};
use common::sampler::{Sampler, Stream};
use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::{CHAPTER, direction};
use crate::furnace;
use crate::lambert::Lambert;
use crate::naive;
use crate::part::Emission;
use crate::space::Space;
use crate::strategy::{ByDirection, Never};
use crate::tracer::PathTracer;
use crate::world::{Surface, World};

/// PT-01: 1 + a + a² + … in a cube and in a ball.
pub(super) const FURNACE: Case = Case {
    id: "PT-01",
    chapter: CHAPTER,
    input: "a path in a furnace: 1 + a + a² + ...",
    most: UNLIMITED,
    naive_fails: |trial| {
        let look = Look::new(trial);
        let mut stream = Stream::of_trial(1212, trial);
        let found = naive::without_cosine(&look.world(), look.ray, look.depth, &mut stream);
        look.is_wrong(found)
    },
    robust_fails: |trial| {
        let look = Look::new(trial);
        let world = look.world();
        let (lighting, ending, depth) = (ByDirection, Never, look.depth);
        let tracer: PathTracer<_, _, _, true, false> =
            PathTracer { world: &world, lighting, ending, depth };
        let sampler = Sampler::new(1211, trial, 0, 1);
        look.is_wrong(tracer.radiance(look.ray, &sampler, &mut Off))
    },
};

static CUBE: LazyLock<Space> = LazyLock::new(|| Space::new(&furnace::cube(0.5).parts));
pub(super) static BALL: LazyLock<Space> = LazyLock::new(|| Space::new(&furnace::ball(0.5).parts));

/// A room of this shape whose wall emits 1 and reflects `albedo`.
pub(super) fn room(space: &Space, albedo: f32) -> World<'_, Lambert> {
    let bsdf = Lambert { reflectance: Color::splat(albedo) };
    let emission = Emission { radiance: Color::ONE, both_sides: true };
    World { space, surfaces: vec![Surface { bsdf, emission }], sky: Color::ZERO }
}

/// A look into a furnace.
struct Look {
    space: &'static Space,
    albedo: f32,
    depth: u32,
    ray: Ray,
}

impl Look {
    fn new(trial: u64) -> Self {
        let mut stream = Stream::of_trial(1210, trial);
        let space: &Space = if trial.is_multiple_of(2) { &CUBE } else { &BALL };
        let mut within = || stream.between(-0.5, 0.5);
        let origin = Vec3::new(within(), within(), within());
        let albedo = stream.between(0.1, 0.99);
        let depth = 1 + stream.bits() % 6;
        Self { space, albedo, depth, ray: Ray { origin, direction: direction(&mut stream) } }
    }

    fn world(&self) -> World<'_, Lambert> {
        room(self.space, self.albedo)
    }

    /// Each of at most 13 roundings is 2⁻²⁴ of the sum or less.
    fn is_wrong(&self, found: Color) -> bool {
        let right = furnace::radiance(f64::from(self.albedo), self.depth);
        found.to_array().iter().any(|&part| !((f64::from(part) - right).abs() <= 1e-6 * right))
    }
}
