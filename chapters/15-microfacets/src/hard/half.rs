//! MF-04: directions between which there is no half.

use common::hard::Case;
use fresnel::conductor::Metal;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::bsdf::Bsdf;

use super::CHAPTER;
use crate::naive;
use crate::rough::Rough;

const SIDES: u64 = 26;
const ROUGHNESS: f32 = 0.3;

/// MF-04: opposite, along the surface and below it.
pub(super) const HALF: Case = Case {
    id: "MF-04",
    chapter: CHAPTER,
    input: "every pair of 26 directions along axes and diagonals",
    most: SIDES * SIDES,
    naive_fails: |trial| {
        let [outgoing, incoming] = pair(trial);
        is_nonsense(naive::cook_torrance(ROUGHNESS, outgoing, incoming))
    },
    robust_fails: |trial| {
        let [outgoing, incoming] = pair(trial);
        let materials =
            [Rough::metal(Metal::GOLD, ROUGHNESS), Rough::glass(Index::GLASS, ROUGHNESS)];
        materials.iter().any(|material| {
            let value = material.eval(outgoing, incoming).to_array();
            value.into_iter().any(is_nonsense) || is_nonsense(material.pdf(outgoing, incoming))
        })
    },
};

fn pair(trial: u64) -> [Vec3; 2] {
    [trial / SIDES, trial % SIDES].map(|side| {
        // Of 27 cells around the middle one, all but that.
        let cell = if side < SIDES / 2 { side } else { side + 1 };
        let part = |digit: u64| (digit % 3) as f32 - 1.0;
        Vec3::new(part(cell), part(cell / 3), part(cell / 9)).normalize()
    })
}

fn is_nonsense(value: f32) -> bool {
    !(value.is_finite() && value >= 0.0)
}
