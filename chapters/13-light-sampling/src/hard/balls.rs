//! LS-01 and LS-02: balls that are far away, and balls that are all but touched.

use std::f32::consts::TAU;

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{Vec2, Vec3};
use path_tracing::space::Piece;
use ray_casting::shape::Hit;
use ray_casting::sphere::Sphere;

use super::{CHAPTER, WAYS, decades, is_broken, lamp};
use crate::lamp::{Lamp, Way};
use crate::naive;

/// LS-01: the solid angle of a ball at a distance of up to 10¹⁸ radii.
pub(super) const CAP: Case = Case {
    id: "LS-01",
    chapter: CHAPTER,
    input: "the solid angle of a ball from 1 + 2^-23 to 10^18 radii away",
    most: UNLIMITED,
    naive_fails: |trial| {
        let distance = distance(trial);
        is_far_from(distance, TAU * naive::cap_height(distance))
    },
    robust_fails: |trial| {
        let distance = distance(trial);
        // Any point of it: all have the same density.
        let nearest = (distance - 1.0) * Vec3::Z;
        let hit = Hit { point: nearest, ..hit() };
        let ball = ball(distance * Vec3::Z);
        ball.is_none_or(|ball| {
            is_far_from(distance, 1.0 / ball.pdf(Vec3::ZERO, Way::SolidAngle, &hit))
        })
    },
};

fn hit() -> Hit {
    let normal = Vec3::NEG_Z;
    Hit { t: 1.0, point: normal, error: Vec3::ZERO, geometric: normal, normal, uv: Vec2::ZERO }
}

fn ball(center: Vec3) -> Option<Lamp> {
    lamp(Piece::Ball(Sphere { center, radius: 1.0 }))
}

fn distance(trial: u64) -> f32 {
    let mut stream = Stream::of_trial(1331, trial);
    let near = 1.0 + decades(&mut stream, -7.0, 0.0).max(f32::EPSILON);
    if trial.is_multiple_of(4) { near } else { decades(&mut stream, 0.01, 18.0) }
}

/// Against 2 sin²(θ / 2) with sin θ = 1 / distance, in `f64`: by more than 8 roundings, half of
/// them those of the cap.
fn is_far_from(distance: f32, found: f32) -> bool {
    let half = libm::sin(libm::asin(1.0 / f64::from(distance)) / 2.0);
    let right = 4.0 * std::f64::consts::PI * half * half;
    // NaN is not within anything.
    !((f64::from(found) / right - 1.0).abs() <= 4.0 * f64::from(f32::EPSILON))
}

/// LS-02: from a ball's surface, give or take some floats, and from inside.
pub(super) const TOUCHING: Case = Case {
    id: "LS-02",
    chapter: CHAPTER,
    input: "a ball seen from its surface and from inside",
    most: UNLIMITED,
    naive_fails: |trial| {
        let height = naive::cap_height(touching(trial).0);
        !(height > 0.0 && height.is_finite())
    },
    robust_fails: |trial| {
        let (distance, u) = touching(trial);
        let Some(ball) = ball(distance * Vec3::Z) else { return true };
        WAYS.into_iter().any(|way| {
            // From the surface itself, the point one stands on has no direction.
            let Some(point) = ball.point(Vec3::ZERO, way, u) else { return distance < 0.999 };
            let pdf = ball.pdf(Vec3::ZERO, way, &point.hit);
            is_broken(&point) || !((pdf / point.pdf - 1.0).abs() <= 1e-3)
        })
    },
};

/// The centre's distance, and two numbers for the point.
fn touching(trial: u64) -> (f32, Vec2) {
    let mut stream = Stream::of_trial(1332, trial);
    let steps = stream.bits() % 33;
    let near = f32::from_bits(1.0_f32.to_bits() + steps - 16);
    let distance = if trial.is_multiple_of(2) { near } else { stream.uniform() };
    (distance, stream.uniform2())
}
