//! WH-10: what comes back and what goes through are all there is, from either side.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::{CHAPTER, direction, index, oracle, upon};
use crate::bend::Incidence;
use crate::dielectric::reflectance;
use crate::index::Index;
use crate::interface::Interface;
use crate::naive;
use crate::slab::{closed, summed};

/// WH-10: a slab keeps all energy, and glass reflects the same from within as from without.
pub(super) const BALANCE: Case = Case {
    id: "WH-10",
    chapter: CHAPTER,
    input: "a slab of glass: all reflections summed, and F from both sides",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (far, direction, normal) = onto(trial);
        let ratio = (1.0 / far.number()) as f32;
        let cosine = -direction.dot(normal);
        let inside = naive::refract(direction, normal, ratio);
        let here = f64::from(naive::reflectance(ratio, cosine));
        let there = inside
            .map_or(1.0, |inside| f64::from(naive::reflectance(1.0 / ratio, -inside.dot(normal))));
        is_one_sided(here, there)
    },
    robust_fails: |trial| {
        let (far, direction, normal) = onto(trial);
        let into = Interface::new(Index::AIR, far);
        let direction = direction.as_dvec3().normalize();
        let incidence = Incidence::new(direction, normal);
        let here = reflectance(&into, incidence.cosine);
        let there = into
            .far_cosine(incidence.cosine)
            .map_or(1.0, |inside| reflectance(&into.reversed(), inside));
        let sum = summed(&into, direction, normal, 1e-7);
        let right = closed(oracle(Index::AIR, far, incidence.cosine));
        // What the sum leaves out is below 10⁻⁷ of radiance inside, times n² below 10.
        is_one_sided(here, there)
            || !((sum.transmitted - right.transmitted).abs() <= 2e-6)
            || !((sum.reflected + sum.transmitted - 1.0).abs() <= 2e-6)
    },
};

fn onto(trial: u64) -> (Index, Vec3, Vec3) {
    let mut stream = Stream::of_trial(717, trial);
    let normal = direction(&mut stream);
    let cosine = f64::from(stream.between(1e-3, 1.0));
    let direction = upon(&mut stream, normal, cosine).as_vec3();
    (index(&mut stream, 1.05, 3.0), direction, normal)
}

/// F(θ, η) = F(θ', 1/η), to 10⁻⁶.
fn is_one_sided(here: f64, there: f64) -> bool {
    !((here - there).abs() <= 1e-6)
}
