//! MC-08: does a check of samples see a density that is a little wrong?

use common::hard::Case;
use common::stats::chi_squared::goodness_of_fit;
use glam::DVec2;

use super::CHAPTER;
use crate::fit;
use crate::warp::hemisphere;

/// MC-08: right claims, and claims that are wrong by 1 % and by 5 %. The naive check is the one of
/// many test suites: each cell may differ by a tenth.
pub(super) const POWER: Case = Case {
    id: "MC-08",
    chapter: CHAPTER,
    input: "is a density right, or 1 % or 5 % off?",
    most: 6,
    naive_fails: |trial| {
        let claim = Claim::of(trial);
        claim.misjudged_by(|observed, expected| {
            let mut cells = observed.iter().zip(expected);
            cells.all(|(&observed, expected)| (observed as f64 / expected - 1.0).abs() < 0.1)
        })
    },
    robust_fails: |trial| {
        Claim::of(trial).misjudged_by(|observed, expected| {
            goodness_of_fit(observed, expected).is_ok_and(|fit| fit.p_value > 1e-4)
        })
    },
};

/// A density that uniform directions are claimed to have.
struct Claim {
    seed: u64,
    planted: f64,
}

impl Claim {
    fn of(trial: u64) -> Self {
        Self { seed: 1111 + trial, planted: [0.0, 0.01, 0.05][trial as usize % 3] }
    }

    /// Whether a check judges this claim wrongly.
    fn misjudged_by(&self, check: fn(&[u64], &[f64]) -> bool) -> bool {
        let samples = if self.planted == 0.05 { 300_000 } else { 2_000_000 };
        let warp = |u| fit::of_direction(hemisphere::uniform(u), 0.0);
        let observed = fit::counts(self.seed, samples, warp);
        // Too much towards x, and too little away from it: in all, as much as there should be.
        let side = |turn: f64| f64::from(common::math::cos((std::f64::consts::TAU * turn) as f32));
        let density = |place: DVec2| 1.0 + self.planted * side(place.y);
        let accepted = check(&observed, &fit::expected(samples, density));
        accepted != (self.planted == 0.0)
    }
}
