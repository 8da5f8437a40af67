//! MF-05, MF-06 and MF-07: visible normals at extremes, at the rim, and what their samples weigh.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{DVec2, DVec3, Vec2, Vec3};
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;

use super::{CHAPTER, at, magnitude};
use crate::conductor::PERFECT;
use crate::facets::{Normals, upright};
use crate::ggx::Ggx;
use crate::naive;
use crate::rough::Rough;

/// MF-05: a normal lies above the surface and faces the view.
pub(super) const EXTREME: Case = Case {
    id: "MF-05",
    chapter: CHAPTER,
    input: "visible normals: straight and grazing views, random numbers at their ends",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (alpha, view, u) = extreme(trial);
        is_hidden(view, naive::visible_by_cap(alpha, view, u))
    },
    robust_fails: |trial| {
        let (alpha, view, u) = extreme(trial);
        is_hidden(view, Ggx { alpha }.visible_normal(view, u))
    },
};

/// MF-06: near the rim of what is seen, a height that comes from 1 - x² - y² has lost its digits.
pub(super) const RIM: Case = Case {
    id: "MF-06",
    chapter: CHAPTER,
    input: "visible normals near the rim, roughness from 10⁻³ to 10⁻², against f64",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (alpha, view, u) = rim(trial);
        let normal = naive::visible_normal(alpha, view, u).as_dvec3();
        !(normal.distance(by_disk(alpha, view, u)) <= APART)
    },
    robust_fails: |trial| {
        let (alpha, view, u) = rim(trial);
        let normal = Ggx { alpha }.visible_normal(view, u).as_dvec3();
        !(normal.distance(by_cap(alpha, view, u)) <= APART)
    },
};

/// MF-07: the samples of all normals may weigh more than all light. Those of visible ones can't.
pub(super) const WEIGHT: Case = Case {
    id: "MF-07",
    chapter: CHAPTER,
    input: "what a sample weighs, at most 1: all roughnesses, all views",
    most: UNLIMITED,
    naive_fails: |trial| weighs_too_much(trial, Normals::All),
    robust_fails: |trial| weighs_too_much(trial, Normals::Visible),
};

/// How far a normal may be from the right one.
const APART: f64 = 1e-3;

fn is_hidden(view: Vec3, normal: Vec3) -> bool {
    let is_unit = (normal.length() - 1.0).abs() < 1e-5;
    !(is_unit && normal.z > 0.0 && view.dot(normal) > -1e-6)
}

fn extreme(trial: u64) -> (f32, Vec3, Vec2) {
    let mut stream = Stream::of_trial(1515, trial);
    let alpha = magnitude(&mut stream, -4.0, 0.0);
    let heights = [1.0, 0.99999, 0.999_989_9, 0.5, 1e-2, 1e-4, 1e-6, 0.0];
    let z = heights[(stream.bits() % 8) as usize];
    let view = at(z, stream.between(0.0, 6.0));
    let mut end = || {
        let inside = stream.uniform();
        [0.0, f32::EPSILON / 2.0, 1.0 - f32::EPSILON / 2.0, inside][(stream.bits() % 4) as usize]
    };
    (alpha, view, Vec2::new(end(), end()))
}

fn any(trial: u64) -> (f32, Vec3, Vec2) {
    let mut stream = Stream::of_trial(1516, trial);
    let alpha = magnitude(&mut stream, -3.0, 0.0);
    let view = at(stream.between(0.0, 1.0), stream.between(0.0, 6.0));
    (alpha, view, stream.uniform2())
}

/// Nearly smooth surfaces, and often the rim.
fn rim(trial: u64) -> (f32, Vec3, Vec2) {
    let (_, view, u) = any(trial);
    let mut stream = Stream::of_trial(1522, trial);
    let alpha = magnitude(&mut stream, -3.0, -2.0);
    (alpha, view, Vec2::new(1.0 - magnitude(&mut stream, -5.0, 0.0), u.y))
}

/// Dupuy and Benyoub's construction in `f64`, as published.
fn by_cap(alpha: f32, view: Vec3, u: Vec2) -> DVec3 {
    let (scale, u) = (scale(alpha), u.as_dvec2());
    let view = (view.as_dvec3() * scale).normalize();
    let z = (1.0 - u.x) * (1.0 + view.z) - view.z;
    let point = (1.0 - z * z).max(0.0).sqrt() * turned(u.y);
    ((point.extend(z) + view) * scale).normalize()
}

/// Heitz's construction in `f64`.
fn by_disk(alpha: f32, view: Vec3, u: Vec2) -> DVec3 {
    let (scale, u) = (scale(alpha), u.as_dvec2());
    let view = (view.as_dvec3() * scale).normalize();
    let first = DVec3::new(-view.y, view.x, 0.0).try_normalize().unwrap_or(DVec3::X);
    let second = view.cross(first);
    let point = u.x.sqrt() * turned(u.y);
    let share = 0.5 * (1.0 + view.z);
    let y = (1.0 - share) * (1.0 - point.x * point.x).max(0.0).sqrt() + share * point.y;
    let z = (1.0 - point.x * point.x - y * y).max(0.0).sqrt();
    ((point.x * first + y * second + z * view) * scale).normalize()
}

fn scale(alpha: f32) -> DVec3 {
    DVec3::new(f64::from(alpha), f64::from(alpha), 1.0)
}

fn turned(turn: f64) -> DVec2 {
    let (y, x) = libm::sincos(std::f64::consts::TAU * turn);
    DVec2::new(x, y)
}

fn weighs_too_much(trial: u64, normals: Normals) -> bool {
    let (alpha, view, _) = any(trial);
    let mut material = Rough::metal(PERFECT, alpha);
    material.facets_mut().normals = normals;
    let sample = material.sample(upright(view), &Random::of_trial(1517, trial));
    sample.is_some_and(|sample| !(sample.weight.max_element() <= 1.0))
}
