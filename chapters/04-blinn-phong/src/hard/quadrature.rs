//! BP-05: how much of a lamp's light a highlight returns, by an integral in `f64`.

use std::f64::consts::TAU;

use common::hard::Case;
use common::math;
use glam::DVec3;

use super::CHAPTER;
use crate::{energy, naive, squaring};

/// BP-05: a surface must not return more light than it gets.
pub(super) const ENERGY: Case = Case {
    id: "BP-05",
    chapter: CHAPTER,
    input: "highlights of n from 1 to 10^6, lit from above to grazing",
    most: (EXPONENTS.len() * COSINES.len()) as u64,
    naive_fails: |trial| is_wrong(trial, naive::normalization),
    robust_fails: |trial| is_wrong(trial, energy::normalization),
};

const EXPONENTS: [u32; 16] =
    [1, 2, 3, 5, 8, 12, 20, 35, 60, 100, 200, 500, 1000, 10_000, 100_000, 1_000_000];

/// Between the normal and the direction that the light comes from.
const COSINES: [f64; 8] = [1.0, 0.95, 0.8, 0.6, 0.4, 0.2, 0.05, 0.001];

/// Of all light no more than all is returned, and from straight above just that.
///
/// The integral is good to 10^-4, which a test shows; the normalization is `f32`.
fn is_wrong(trial: u64, normalization: fn(f32) -> f32) -> bool {
    let exponent = EXPONENTS[trial as usize / COSINES.len()];
    let cosine = COSINES[trial as usize % COSINES.len()];
    let returned = f64::from(normalization(exponent as f32)) * integral(exponent, cosine);
    let complete = cosine < 1.0 || returned >= 1.0 - 1e-3;
    !(returned <= 1.0 + 1e-3 && complete)
}

// ANCHOR: integral
/// The integral of (N · H)ⁿ (N · L) over all directions L to a lamp, for an eye at this cosine.
///
/// Over half vectors instead of lamps, where the peak is: dω_L = 4 (V · H) dω_H. And over
/// y = 1 - N · H, halved down to 2^-40, so that the grid is as fine as any peak is narrow.
pub(crate) fn integral(exponent: u32, cosine: f64) -> f64 {
    let eye = DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
    let ring = |y: f64| squaring::power(1.0, 1.0 - y, exponent) * around(y, eye);
    let octaves = (0..40).map(|octave| 1.0 / (1u64 << octave) as f64);
    octaves.map(|high| gauss(high / 2.0, high, ring)).sum()
}

/// The integral over all half vectors with this y: around the normal once.
fn around(y: f64, eye: DVec3) -> f64 {
    const STEPS: u32 = 128;
    let (height, radius) = (1.0 - y, (y * (2.0 - y)).sqrt());
    let term = |step: u32| {
        let angle = (step as f32 + 0.5) / STEPS as f32 * std::f32::consts::TAU;
        let (x, y) = (f64::from(math::cos(angle)), f64::from(math::sin(angle)));
        let half = DVec3::new(radius * x, radius * y, height);
        let toward_eye = eye.dot(half).max(0.0);
        let light = 2.0 * toward_eye * half.z - eye.z;
        4.0 * toward_eye * light.max(0.0)
    };
    (0..STEPS).map(term).sum::<f64>() * TAU / f64::from(STEPS)
}
// ANCHOR_END: integral

/// Gauss and Legendre's rule of five points, on eight equal parts.
fn gauss(low: f64, high: f64, value: impl Fn(f64) -> f64) -> f64 {
    const PARTS: u32 = 8;
    const POINTS: [(f64, f64); 5] = [
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
        (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    let half = (high - low) / f64::from(2 * PARTS);
    let part = |index: u32| {
        let middle = low + half * f64::from(2 * index + 1);
        POINTS.iter().map(|(at, weight)| weight * value(middle + half * at)).sum::<f64>() * half
    };
    (0..PARTS).map(part).sum()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::{EXPONENTS, integral};
    use crate::naive;
    use crate::squaring::power;

    /// From straight above the integral has a closed form: 8π (n + 2^(-n/2)) / (n + 2)(n + 4).
    #[test]
    fn the_integral_is_right_where_it_is_known() {
        for exponent in EXPONENTS.into_iter().filter(|exponent| exponent % 2 == 0) {
            let n = f64::from(exponent);
            let exact = 8.0 * PI * (n + power(1.0, 0.5, exponent / 2)) / ((n + 2.0) * (n + 4.0));
            let error = integral(exponent, 1.0) / exact - 1.0;
            assert!(error.abs() < 1e-4, "{exponent}: {error:e}");
        }
        // An exponent of 0 leaves the cosine: π, whatever the eye.
        for cosine in [1.0, 0.7, 0.2, 0.01] {
            let error = integral(0, cosine) / PI - 1.0;
            assert!(error.abs() < 1e-3, "{cosine}: {error:e}");
        }
    }

    /// What the page says of the approximation: at n = 8 it returns 7.5 % too much.
    #[test]
    fn the_approximation_is_off_by_seven_percent() {
        let returned = f64::from(naive::normalization(8.0)) * integral(8, 1.0);
        assert!((returned - 1.075).abs() < 1e-3, "{returned}");
    }
}
