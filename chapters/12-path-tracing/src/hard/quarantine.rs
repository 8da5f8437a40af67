//! PT-06: samples that are no numbers are counted, and left out of the mean.

use common::film::{Color, Mean};
use common::hard::{Case, UNLIMITED};
use common::sampler::Sampler;
use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::CHAPTER;
use super::furnace::BALL;
use crate::bsdf::{Bsdf, BsdfSample};
use crate::lambert::Lambert;
use crate::naive;
use crate::part::Emission;
use crate::random::{LOBE, Random};
use crate::strategy::{ByDirection, Never};
use crate::tracer::PathTracer;
use crate::world::{Surface, World};

/// PT-06: the mean of the rest, and how many there were.
pub(super) const COUNTED: Case = Case {
    id: "PT-06",
    chapter: CHAPTER,
    input: "a pixel of 8 samples, some of which are NaN",
    most: UNLIMITED,
    naive_fails: |trial| {
        let mean = naive::mean_with_black(&pixel(trial));
        !((mean - RIGHT).abs().max_element() <= 1e-6)
    },
    robust_fails: |trial| {
        let mut mean = Mean::default();
        pixel(trial).into_iter().for_each(|sample| mean.add(sample));
        let broken = (0..SAMPLES).filter(|&index| is_broken(&first(&sampler(trial, index))));
        let broken = broken.count() as u64;
        let right = if broken < u64::from(SAMPLES) { RIGHT } else { Color::ZERO };
        mean.nonfinite() != broken || !((mean.color() - right).abs().max_element() <= 1e-6)
    },
};

const SAMPLES: u32 = 8;

/// In a furnace of albedo a half, one surface left: 1 + 1/2.
const RIGHT: Color = Color::splat(1.5);

/// A surface with a fault: now and then its weight is no number.
#[derive(Clone, Copy, Debug)]
struct Faulty(Lambert);

impl Bsdf for Faulty {
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        self.0.eval(outgoing, incoming)
    }

    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        self.0.pdf(outgoing, incoming)
    }

    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        let sample = self.0.sample(outgoing, random)?;
        let weight = if is_broken(random) { Color::NAN } else { sample.weight };
        Some(BsdfSample { weight, ..sample })
    }

    fn spreads(&self) -> bool {
        true
    }
}

fn is_broken(random: &Random) -> bool {
    random.number(LOBE) < 0.2
}

fn sampler(trial: u64, index: u32) -> Sampler {
    Sampler::new(1260, trial, index, SAMPLES)
}

/// The random numbers at the first surface.
fn first(sampler: &Sampler) -> Random {
    Random::at(sampler, 1)
}

fn pixel(trial: u64) -> Vec<Color> {
    let bsdf = Faulty(Lambert { reflectance: Color::splat(0.5) });
    let emission = Emission { radiance: Color::ONE, both_sides: true };
    let world =
        World { space: &BALL, surfaces: vec![Surface { bsdf, emission }], sky: Color::ZERO };
    let (lighting, ending, depth) = (ByDirection, Never, 1);
    let tracer: PathTracer<_, _, _, true, false> =
        PathTracer { world: &world, lighting, ending, depth };
    let ray = Ray { origin: Vec3::new(0.1, -0.2, 0.3), direction: Vec3::X };
    (0..SAMPLES).map(|index| tracer.radiance(ray, &sampler(trial, index), &mut Off)).collect()
}
