//! What all rough materials have to keep: energy, both directions, and one density.

mod density;
mod energy;
mod two_ways;

use common::sampler::Stream;
use fresnel::conductor::Metal;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::random::Random;

use crate::conductor::PERFECT;
use crate::facets::{Masking, Normals};
use crate::rough::Rough;

/// Rough materials of all kinds and choices.
fn materials(alpha: f32) -> Vec<Rough> {
    let water = Index::new(0.75).expect("an index");
    let kinds = [
        Rough::metal(Metal::GOLD, alpha),
        Rough::metal(PERFECT, alpha),
        Rough::glass(Index::GLASS, alpha),
        Rough::glass(water, alpha),
    ];
    let mut all = Vec::new();
    for kind in kinds {
        for normals in [Normals::Visible, Normals::All] {
            for masking in [Masking::Correlated, Masking::Separable] {
                let mut material = kind;
                let facets = material.facets_mut();
                (facets.normals, facets.masking) = (normals, masking);
                all.push(material);
            }
        }
    }
    all
}

/// The direction whose height is `z`, turned by `turn`.
fn at(z: f32, turn: f32) -> Vec3 {
    let radius = ((1.0 - z) * (1.0 + z)).sqrt();
    Vec3::new(radius * common::math::cos(turn), radius * common::math::sin(turn), z)
}

/// A direction, above or below.
fn direction(stream: &mut Stream) -> Vec3 {
    at(stream.between(-1.0, 1.0), stream.between(0.0, 6.0))
}

fn random(seed: u64, trial: u64) -> Random {
    Random::of_trial(seed, trial)
}
