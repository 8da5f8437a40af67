//! MF-12: metals at the ends of what metals can be.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use fresnel::conductor::reflectance;

use super::{CHAPTER, magnitude};
use crate::naive;

/// MF-12: n near 0, k up to 1000, and down to grazing.
pub(super) const METAL: Case = Case {
    id: "MF-12",
    chapter: CHAPTER,
    input: "F of metals: n from 10⁻⁶ to 10, k from 10⁻³ to 1000, grazing too",
    most: UNLIMITED,
    naive_fails: |trial| {
        let [n, k, cosine] = metal(trial);
        is_off(f64::from(naive::metal(n, k, cosine)), [n, k, cosine])
    },
    robust_fails: |trial| {
        let [n, k, cosine] = metal(trial);
        is_off(reflectance(n.into(), k.into(), cosine.into()), [n, k, cosine])
    },
};

fn metal(trial: u64) -> [f32; 3] {
    let mut stream = Stream::of_trial(1521, trial);
    let (n, k) = (magnitude(&mut stream, -6.0, 1.0), magnitude(&mut stream, -3.0, 3.0));
    let cosine = if stream.uniform() < 0.05 { 0.0 } else { stream.uniform() };
    [n, k, cosine]
}

/// Whether it is no part, or off by more than 10⁻⁵.
fn is_off(found: f64, [n, k, cosine]: [f32; 3]) -> bool {
    let right = by_complex_numbers(n.into(), k.into(), cosine.into());
    !((0.0..=1.0).contains(&found) && (found - right).abs() <= 1e-5)
}

/// Fresnel's equations with a complex index: the root of (n + i k)² - sin²θ by its length and angle.
fn by_complex_numbers(n: f64, k: f64, cosine: f64) -> f64 {
    let (real, imaginary) = (n * n - k * k - (1.0 - cosine * cosine), 2.0 * n * k);
    let length = libm::sqrt(libm::hypot(real, imaginary));
    let half = libm::atan2(imaginary, real) / 2.0;
    let root = [length * libm::cos(half), length * libm::sin(half)];

    // |cosθ - root|² / |cosθ + root|², and the same with (n + i k)² cosθ.
    let part = |[x, y]: [f64; 2]| {
        let square = |a: f64, b: f64| a * a + b * b;
        let below = square(x + root[0], y + root[1]);
        if below > 0.0 { square(x - root[0], y - root[1]) / below } else { 1.0 }
    };
    let parallel = [(n * n - k * k) * cosine, imaginary * cosine];
    (part([cosine, 0.0]) + part(parallel)) / 2.0
}
