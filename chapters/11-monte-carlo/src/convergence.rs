//! How fast an error falls with the number of samples.

use glam::Vec2;

use crate::estimator::{Sample, mean};
use crate::points::Points;

// ANCHOR: error
/// The error of a mean of `count` samples: the root of the mean of its squares over `seeds` seeds.
///
/// `strategy` makes a sample from a point of the unit square, and `exact` is the right answer.
pub fn error(
    points: Points,
    count: u32,
    seeds: u64,
    exact: f64,
    strategy: impl Fn(Vec2) -> Sample,
) -> f64 {
    let of = |seed| mean(count, |index| strategy(points.at(index, count, seed))).mean() - exact;
    let squares = (0..seeds).map(|seed| of(seed) * of(seed)).sum::<f64>();
    (squares / seeds as f64).sqrt()
}
// ANCHOR_END: error

/// The exponent s in an error that falls as Nˢ, from the errors at two numbers of samples.
pub fn slope(counts: [u32; 2], errors: [f64; 2]) -> f64 {
    let [few, many] = counts.map(f64::from);
    common::math::log10(errors[1] / errors[0]) / common::math::log10(many / few)
}

#[cfg(test)]
mod tests {
    use super::{error, slope};
    use crate::points::Points;
    use crate::sky;

    fn slope_of(points: Points) -> f64 {
        let counts = [64, 4096];
        slope(counts, counts.map(|count| error(points, count, 200, sky::IRRADIANCE, sky::uniform)))
    }

    #[test]
    fn chance_falls_as_the_root_and_even_points_faster() {
        assert!((slope_of(Points::Random) + 0.5).abs() < 0.05);
        assert!(slope_of(Points::Stratified) < -0.7 && slope_of(Points::Sobol) < -0.7);
    }

    #[test]
    fn a_slope_by_hand() {
        assert!((slope([100, 10_000], [0.5, 0.05]) + 0.5).abs() < 1e-12);
    }
}
