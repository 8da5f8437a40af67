//! BP-04: corner normals that cancel.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;
use triangles::surface::smooth_normal;

use super::CHAPTER;
use super::draw::{decade, direction};
use crate::naive;

/// BP-04: the normal between two that are opposite.
pub(super) const NORMAL: Case = Case {
    id: "BP-04",
    chapter: CHAPTER,
    input: "between opposite corner normals, 0 to 10^-2 from the middle",
    most: UNLIMITED,
    naive_fails: |trial| {
        let Between { normals, weights, .. } = between(trial);
        between(trial).is_wrong(naive::smooth_normal(normals, weights))
    },
    robust_fails: |trial| {
        let Between { normals, weights, geometric } = between(trial);
        between(trial).is_wrong(smooth_normal(normals, weights, geometric))
    },
};

struct Between {
    normals: [Vec3; 3],
    weights: Vec3,
    geometric: Vec3,
}

fn between(trial: u64) -> Between {
    let mut stream = Stream::of_trial(404, trial);
    let [normal, other, geometric] = [(); 3].map(|()| direction(&mut stream));
    let aside = match stream.bits() % 4 {
        0 => 0.0,
        _ => decade(&mut stream, -9.0, -2.0),
    };
    let weights = Vec3::new(0.5 + aside, 0.5 - aside, 0.0);
    Between { normals: [normal, -normal, other], weights, geometric }
}

impl Between {
    /// A normal of length 1, and a hundredth of a radian from the mean of `f64` or the triangle's
    /// own.
    ///
    /// The mean of `f32` is wrong by 3 u. Where it is shorter than 10^-4, its direction may be
    /// wrong by more than 0.002; ours is not asked for it there.
    fn is_wrong(&self, found: Vec3) -> bool {
        let [a, b, c] = self.normals.map(|normal| normal.as_dvec3());
        let weights = self.weights.as_dvec3();
        let mean = (weights.x * a + weights.y * b + weights.z * c).normalize_or_zero();
        let found_exact = found.as_dvec3();
        let length = (found_exact.length() - 1.0).abs() <= 3e-7;
        !(length && (found == self.geometric || (found_exact - mean).length() <= 0.01))
    }
}
