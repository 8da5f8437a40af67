//! WH-02, WH-04 and WH-07: cosines above 1, near 0 and on the wrong side.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::{CHAPTER, direction, index, oracle};
use crate::bend::{Incidence, precise};
use crate::dielectric;
use crate::index::Index;
use crate::interface::Interface;
use crate::naive;
use crate::schlick;

/// WH-02: a ray along the normal, both of length 1 but for rounding.
pub(super) const ABOVE_ONE: Case = Case {
    id: "WH-02",
    chapter: CHAPTER,
    input: "a ray along the normal: the cosine may be above 1",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (along, normal, far) = straight(trial);
        let ratio = (1.0 / far.number()) as f32;
        is_far_from(far, f64::from(naive::reflectance(ratio, -along.dot(normal))))
    },
    robust_fails: |trial| {
        let (along, normal, far) = straight(trial);
        let incidence = Incidence::new(precise(along), normal);
        let into = Interface::new(Index::AIR, far);
        is_far_from(far, dielectric::reflectance(&into, incidence.cosine))
    },
};

fn straight(trial: u64) -> (Vec3, Vec3, Index) {
    let mut stream = Stream::of_trial(712, trial);
    let normal = direction(&mut stream);
    (-normal, normal, index(&mut stream, 1.1, 3.0))
}

/// Straight upon it ((n - 1) / (n + 1))² is reflected, and nearly so at angles of 10⁻⁴.
fn is_far_from(far: Index, found: f64) -> bool {
    let amplitude = (far.number() - 1.0) / (far.number() + 1.0);
    // NaN is not within anything.
    !((found - amplitude * amplitude).abs() <= 1e-6)
}

/// WH-04: cosines from 0 on.
pub(super) const GRAZING: Case = Case {
    id: "WH-04",
    chapter: CHAPTER,
    input: "grazing light: a cosine of 0 to 10^-3",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (far, cosine) = grazing(trial);
        let ratio = (1.0 / far.number()) as f32;
        is_not_nearly_all(far, cosine, f64::from(naive::by_angles(ratio, cosine)))
    },
    robust_fails: |trial| {
        let (far, cosine) = grazing(trial);
        let into = Interface::new(Index::AIR, far);
        is_not_nearly_all(far, cosine, dielectric::reflectance(&into, f64::from(cosine)))
    },
};

fn grazing(trial: u64) -> (Index, f32) {
    let mut stream = Stream::of_trial(713, trial);
    let far = index(&mut stream, 1.1, 3.0);
    let cosine = stream.between(0.0, 1e-3);
    // One in eight is 0 itself, one a number so small that its square is none.
    (far, [0.0, cosine * 1e-30][..].get(stream.bits() as usize % 8).copied().unwrap_or(cosine))
}

/// Never more than all; all at a cosine of 0; and between, what `f64` says.
fn is_not_nearly_all(far: Index, cosine: f32, found: f64) -> bool {
    let right = oracle(Index::AIR, far, f64::from(cosine));
    !(found <= 1.0 && (found - right).abs() <= 1e-7) || (cosine == 0.0 && found != 1.0)
}

/// WH-07: Schlick's polynomial out of glass, and for cosines that are none.
pub(super) const SCHLICK: Case = Case {
    id: "WH-07",
    chapter: CHAPTER,
    input: "Schlick's polynomial: out of glass, and cosines from -0.1 to 1.0000004",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (leaving, cosine) = out_of_glass(trial);
        let ratio = leaving.ratio() as f32;
        is_not_entering(&leaving, cosine, f64::from(naive::schlick(ratio, cosine)))
    },
    robust_fails: |trial| {
        let (leaving, cosine) = out_of_glass(trial);
        is_not_entering(&leaving, cosine, schlick::reflectance(&leaving, f64::from(cosine)))
    },
};

fn out_of_glass(trial: u64) -> (Interface, f32) {
    let mut stream = Stream::of_trial(714, trial);
    let leaving = Interface::new(index(&mut stream, 1.1, 2.5), Index::AIR);
    (leaving, stream.between(-0.1, 1.000_000_4))
}

/// It must be a part of the light, all of it beyond the critical angle, and otherwise as much as
/// for the same path the other way: Schlick's own equation for the angle in the air, by the sine.
fn is_not_entering(leaving: &Interface, cosine: f32, found: f64) -> bool {
    let cosine = f64::from(cosine).clamp(0.0, 1.0);
    let sine = leaving.ratio() * (1.0 - cosine * cosine).sqrt();
    let outside = (1.0 - sine * sine).max(0.0).sqrt();
    let straight = schlick::straight(leaving);
    let x = 1.0 - outside;
    let right = straight + (1.0 - straight) * x * x * x * x * x;
    // Near the critical angle the root makes 10⁻⁸ of a rounding of 10⁻¹⁶.
    !((0.0..=1.0).contains(&found) && (found - right).abs() <= 1e-6)
}
