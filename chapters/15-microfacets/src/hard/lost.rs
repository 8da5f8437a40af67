//! MF-11: samples that are lost count nothing; they are not drawn again.

use common::hard::Case;
use common::stats::estimate::{Estimate, z_test};
use common::stats::running::Running;
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;

use super::{CHAPTER, at};
use crate::albedo::roughest;
use crate::conductor::PERFECT;
use crate::facets::Masking;
use crate::rough::Rough;

const HEIGHTS: [f32; 8] = [1.0, 0.9, 0.8, 0.6, 0.4, 0.2, 0.1, 0.05];
const SAMPLES: u64 = 20_000;

/// MF-11: the mean over what was not lost is not the mean.
pub(super) const LOST: Case = Case {
    id: "MF-11",
    chapter: CHAPTER,
    input: "the light of a surface of roughness 1, half of whose samples are lost",
    most: HEIGHTS.len() as u64,
    naive_fails: |trial| is_wrong(trial, |sample| sample),
    robust_fails: |trial| is_wrong(trial, |sample| Some(sample.unwrap_or(0.0))),
};

/// Whether the mean of what `counted` makes of the samples is not the closed form's.
fn is_wrong(trial: u64, counted: fn(Option<f64>) -> Option<f64>) -> bool {
    let outgoing = at(HEIGHTS[trial as usize], 0.4);
    let material = Rough::metal(PERFECT, 1.0);
    let weight = |sample| {
        let random = Random::of_trial(1520, trial * SAMPLES + sample);
        counted(material.sample(outgoing, &random).map(|it| f64::from(it.weight.x)))
    };
    let weights: Running = (0..SAMPLES).filter_map(weight).collect();
    let right = Estimate::exact(roughest(f64::from(outgoing.z), Masking::Correlated));
    let Some(found) = Estimate::of(&weights) else { return true };
    !(z_test(&found, &right).p_value > 1e-6)
}
