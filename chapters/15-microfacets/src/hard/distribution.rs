//! MF-01 and MF-03: D near the top of its lobe, and masking near the horizon.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::{CHAPTER, at, magnitude, off};
use crate::ggx::Ggx;
use crate::naive;

/// MF-01: cos²θ (α² - 1) + 1 is 1 - 1 and a rest.
pub(super) const DENSITY: Case = Case {
    id: "MF-01",
    chapter: CHAPTER,
    input: "D within ten times the lobe's width, roughness from 10⁻⁵ to 1",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (alpha, normal) = facet(trial);
        off(naive::density(alpha, normal.z), density(alpha, normal), 1e-5)
    },
    robust_fails: |trial| {
        let (alpha, normal) = facet(trial);
        off(Ggx { alpha }.density(normal), density(alpha, normal), 2e-6)
    },
};

/// MF-03: tan²θ overflows where the cosine's square does not fit.
pub(super) const MASKING: Case = Case {
    id: "MF-03",
    chapter: CHAPTER,
    input: "masking of views down to a cosine of 10⁻³⁰",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (alpha, view) = view(trial);
        off(naive::masking(alpha, view.z), masking(alpha, view), 1e-5)
    },
    robust_fails: |trial| {
        let (alpha, view) = view(trial);
        off(Ggx { alpha }.masking(view), masking(alpha, view), 1e-6)
    },
};

fn facet(trial: u64) -> (f32, Vec3) {
    let mut stream = Stream::of_trial(1511, trial);
    let alpha = magnitude(&mut stream, -5.0, 0.0);
    let slope = stream.between(0.0, 10.0) * alpha;
    let turn = stream.between(0.0, 6.0);
    let (x, y) = (common::math::cos(turn), common::math::sin(turn));
    (alpha, Vec3::new(slope * x, slope * y, 1.0).normalize())
}

/// The equation as printed, α² / (π cos⁴θ (α² + tan²θ)²), in `f64`.
fn density(alpha: f32, normal: Vec3) -> f64 {
    let (square, normal) = (f64::from(alpha) * f64::from(alpha), normal.as_dvec3().normalize());
    let cosine_squared = normal.z * normal.z;
    let slope = normal.truncate().length_squared() / cosine_squared;
    let spread = cosine_squared * (square + slope);
    square / (std::f64::consts::PI * spread * spread)
}

fn view(trial: u64) -> (f32, Vec3) {
    let mut stream = Stream::of_trial(1512, trial);
    let alpha = magnitude(&mut stream, -3.0, 0.0);
    let z = magnitude(&mut stream, -30.0, 0.0);
    (alpha, at(z, stream.between(0.0, 6.0)))
}

/// 1 / (1 + Λ) with the slope's square in `f64`, where it fits.
fn masking(alpha: f32, view: Vec3) -> f64 {
    let (alpha, view) = (f64::from(alpha), view.as_dvec3());
    let slope = view.truncate().length_squared() / (view.z * view.z);
    2.0 / (1.0 + (1.0 + alpha * alpha * slope).sqrt())
}
