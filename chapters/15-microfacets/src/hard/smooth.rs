//! MF-02: surfaces that are hardly rough, or not at all.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use fresnel::conductor::Metal;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::bsdf::Bsdf;
use path_tracing::random::{DIRECTION, Random};

use super::{CHAPTER, at, magnitude};
use crate::facets::reflected;
use crate::ggx::Ggx;
use crate::naive;
use crate::rough::Rough;

/// MF-02: what is hardly rough, and what is not at all, is a mirror.
pub(super) const SMOOTH: Case = Case {
    id: "MF-02",
    chapter: CHAPTER,
    input: "a roughness of 0, and from 10⁻³⁰ to 10⁻³: all but a mirror",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (alpha, outgoing, random) = mirror(trial);
        let normal = Ggx { alpha }.normal(random.pair(DIRECTION));
        let incoming = reflected(outgoing, normal);
        let value = naive::cook_torrance(alpha, outgoing, incoming) * incoming.z;
        let pdf = naive::density(alpha, normal.z) * normal.z / (4.0 * outgoing.dot(normal));
        !((value / pdf - 1.0).abs() <= 0.02)
    },
    robust_fails: |trial| {
        let (alpha, outgoing, random) = mirror(trial);
        let sample = Rough::metal(Metal::SILVER, alpha).sample(outgoing, &random);
        let right = Metal::SILVER.reflectance(Index::AIR, f64::from(outgoing.z));
        !sample.is_some_and(|sample| (sample.weight - right).abs().max_element() <= 0.02)
    },
};

fn mirror(trial: u64) -> (f32, Vec3, Random) {
    let mut stream = Stream::of_trial(1513, trial);
    let tiny = magnitude(&mut stream, -30.0, -3.001);
    let alpha = if stream.uniform() < 0.1 { 0.0 } else { tiny };
    // Not so low that a rare steep facet sends the light down.
    let outgoing = at(stream.between(0.9, 1.0), stream.between(0.0, 6.0));
    (alpha, outgoing, Random::of_trial(1514, trial))
}
