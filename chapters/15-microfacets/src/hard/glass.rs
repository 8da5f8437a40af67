//! MF-09: rough glass is the same from both sides, once radiance is counted right.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::bsdf::Bsdf;

use super::{CHAPTER, at};
use crate::rough::Rough;

/// MF-09: what is refracted is over n² the same there and back; without that it is not.
pub(super) const TWO_WAYS: Case = Case {
    id: "MF-09",
    chapter: CHAPTER,
    input: "frosted glass, there and back",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (glass, [above, below], _) = passage(trial);
        differs(glass.eval(above, below).x, glass.eval(below, above).x)
    },
    robust_fails: |trial| {
        let (glass, [above, below], index) = passage(trial);
        // Coming from below, light is in glass: there the square counts.
        let there = glass.eval(above, below).x / (index * index);
        differs(there, glass.eval(below, above).x)
    },
};

fn passage(trial: u64) -> (Rough, [Vec3; 2], f32) {
    let mut stream = Stream::of_trial(1518, trial);
    let index = stream.between(1.2, 2.5);
    let alpha = stream.between(0.05, 1.0);
    let glass = Rough::glass(Index::new(index).unwrap_or(Index::GLASS), alpha);
    let above = at(stream.between(0.01, 1.0), stream.between(0.0, 6.0));
    let below = at(-stream.between(0.01, 1.0), stream.between(0.0, 6.0));
    (glass, [above, below], index)
}

/// By more than a hundredth. What is far off the lobe, where nothing is left, doesn't count.
fn differs(one: f32, other: f32) -> bool {
    !((one - other).abs() <= 0.01 * one.max(other).max(1e-6))
}
