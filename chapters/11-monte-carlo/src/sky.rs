//! An integral with a known answer: the light that a cloudy sky sends to a floor.

use std::f64::consts::PI;

use glam::{Vec2, Vec3};

use crate::estimator::Sample;
use crate::warp::hemisphere;

// ANCHOR: sky
/// The radiance from a direction above the floor, whose normal is z: three times as much from above
/// as from the horizon, and more from the side of x, where the sun is behind the clouds.
///
/// Over x it is the standard overcast sky of the CIE (Moon and Spencer, 1942), (1 + 2 z) / 3.
#[inline]
pub fn radiance(direction: Vec3) -> f32 {
    (1.0 + 2.0 * direction.z) / 3.0 * (1.0 + 0.5 * direction.x)
}

/// The irradiance: the integral of radiance times z over the hemisphere. What the side of x has more,
/// the other side has less; the rest is 2π (1/2 + 2/3) / 3.
pub const IRRADIANCE: f64 = 7.0 * PI / 9.0;
// ANCHOR_END: sky

// ANCHOR: uniform
/// A sample of the irradiance, from all directions alike.
#[inline]
pub fn uniform(u: Vec2) -> Sample {
    sample(hemisphere::uniform(u), hemisphere::UNIFORM)
}
// ANCHOR_END: uniform

// ANCHOR: cosine
/// A sample from directions that are as dense as their cosine.
#[inline]
pub fn cosine(u: Vec2) -> Sample {
    let direction = hemisphere::cosine(u);
    sample(direction, hemisphere::cosine_density(direction.z))
}
// ANCHOR_END: cosine

#[inline]
fn sample(direction: Vec3, density: f32) -> Sample {
    let value = radiance(direction) * direction.z;
    Sample { value: f64::from(value), density: f64::from(density) }
}

// ANCHOR: variance
/// The variance of one estimate of [`uniform`]: (2π/3)² times the integral over heights of
/// z² (1 + 2z)² (1 + (1 - z²) / 8), which is 373/168, less the square of the answer.
pub const UNIFORM_VARIANCE: f64 = 4.0 * PI * PI / 9.0 * 373.0 / 168.0 - IRRADIANCE * IRRADIANCE;
// ANCHOR_END: variance

#[cfg(test)]
mod tests {
    use common::stats::estimate::{Estimate, z_test};

    use super::{IRRADIANCE, UNIFORM_VARIANCE, cosine, uniform};
    use crate::estimator::mean;
    use crate::points::Points;

    #[test]
    fn both_ways_find_the_answer() {
        for strategy in [uniform, cosine] {
            let found = mean(200_000, |index| strategy(Points::Random.at(index, 200_000, 3)));
            let found = Estimate::of(&found).expect("many samples");
            assert!(z_test(&found, &Estimate::exact(IRRADIANCE)).p_value > 1e-4, "{found:?}");
        }
    }

    #[test]
    fn the_variance_is_the_one_on_paper() {
        let found = mean(200_000, |index| uniform(Points::Random.at(index, 200_000, 3)));
        let ratio = found.variance().expect("many samples") / UNIFORM_VARIANCE;
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
    }

    #[test]
    fn cosines_have_less_variance() {
        let variance = |strategy: fn(glam::Vec2) -> crate::estimator::Sample| {
            mean(100_000, |index| strategy(Points::Random.at(index, 100_000, 5))).variance()
        };
        assert!(variance(uniform) > variance(cosine).map(|variance| 3.0 * variance));
    }
}
