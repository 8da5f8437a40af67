//! X-09, MC-02, MC-03, MC-06 and LS-01: directions, and what is made of them.

use std::f32::consts::PI;

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{Vec2, Vec3};

use super::CHAPTER;
use crate::estimator::Sample;
use crate::frame::Frame;
use crate::warp::cap::Cap;
use crate::warp::hemisphere;
use crate::{angle, naive};

/// axes around directions that are nearly -z.
pub(super) const FRAME: Case = Case {
    id: "X-09",
    chapter: CHAPTER,
    input: "axes around a direction within 10^-7 to 1 of -z",
    most: UNLIMITED,
    naive_fails: |trial| {
        let normal = near_minus_z(trial);
        let [tangent, bitangent] = naive::frame(normal);
        are_not_axes([tangent, bitangent, normal])
    },
    robust_fails: |trial| {
        let Frame { tangent, bitangent, normal } = Frame::around(near_minus_z(trial));
        are_not_axes([tangent, bitangent, normal])
    },
};

fn near_minus_z(trial: u64) -> Vec3 {
    let mut stream = Stream::of_trial(1105, trial);
    let away = common::math::pow(10.0, stream.between(-7.0, 0.0));
    let across = Vec2::new(stream.between(-1.0, 1.0), stream.between(-1.0, 1.0));
    (away * across).extend(-1.0).normalize()
}

/// Right angles and lengths of 1, to a few roundings.
fn are_not_axes(axes: [Vec3; 3]) -> bool {
    let [x, y, z] = axes.map(Vec3::as_dvec3);
    let errors = [x.dot(y), y.dot(z), z.dot(x), x.length() - 1.0, y.length() - 1.0];
    !errors.into_iter().all(|error| error.abs() <= 1e-6)
}

/// MC-02: points of the square's edge become points of the rim.
pub(super) const RIM: Case = Case {
    id: "MC-02",
    chapter: CHAPTER,
    input: "the square's edge, which becomes the disk's rim, raised to a hemisphere",
    most: UNLIMITED,
    naive_fails: |trial| is_no_direction(naive::cosine(on_edge(trial))),
    robust_fails: |trial| is_no_direction(hemisphere::cosine(on_edge(trial))),
};

fn on_edge(trial: u64) -> Vec2 {
    let mut stream = Stream::of_trial(1106, trial);
    let along = stream.uniform();
    let far = 1.0f32.next_down();
    [Vec2::new(0.0, along), Vec2::new(along, 0.0), Vec2::new(far, along), Vec2::new(along, far)]
        [trial as usize % 4]
}

fn is_no_direction(direction: Vec3) -> bool {
    !(direction.z >= 0.0 && (direction.as_dvec3().length() - 1.0).abs() <= 1e-6)
}

/// MC-03: light over density, where both are nearly nothing.
pub(super) const NO_DENSITY: Case = Case {
    id: "MC-03",
    chapter: CHAPTER,
    input: "a cosine over its density, on the rim",
    most: UNLIMITED,
    naive_fails: |trial| {
        let z = naive::clamped_cosine(on_edge(trial)).z;
        is_not_pi(z / (z / PI))
    },
    robust_fails: |trial| {
        let z = hemisphere::cosine(on_edge(trial)).z;
        let density = f64::from(hemisphere::cosine_density(z));
        is_not_pi(Sample { value: f64::from(z), density }.estimate() as f32)
    },
};

/// Each sample of the cosine's integral must be the integral, π.
fn is_not_pi(estimate: f32) -> bool {
    !((estimate - PI).abs() <= 1e-6)
}

/// MC-06: the angle of two directions, many of them equal or nearly so.
pub(super) const ANGLE: Case = Case {
    id: "MC-06",
    chapter: CHAPTER,
    input: "the angle between two directions, from 0 to 1",
    most: UNLIMITED,
    naive_fails: |trial| {
        let [one, other] = two_directions(trial);
        is_not_angle(one, other, naive::angle(one, other))
    },
    robust_fails: |trial| {
        let [one, other] = two_directions(trial);
        is_not_angle(one, other, angle::between(one, other))
    },
};

fn two_directions(trial: u64) -> [Vec3; 2] {
    let mut stream = Stream::of_trial(1107, trial);
    let [u, v] = [stream.uniform2(), stream.uniform2()];
    let one = crate::warp::sphere::uniform(u);
    let away = if trial.is_multiple_of(4) { 0.0 } else { common::math::pow(10.0, -6.0 * v.x) };
    let other = one + away * Frame::around(one).to_world(Vec3::new(v.y, 1.0 - v.y, 0.0));
    [one, other.normalize()]
}

/// The same angle in `f64`, by Kahan's formula: twice the arc tangent of half the chords.
fn is_not_angle(one: Vec3, other: Vec3, found: f32) -> bool {
    let [one, other] = [one, other].map(|vector| vector.as_dvec3().normalize());
    let right = 2.0 * half_angle((one - other).length(), (one + other).length());
    !((f64::from(found) - right).abs() <= 1e-6)
}

/// The arc tangent of y / x, for y from 0 to x, as twice that of half the angle and so on: the
/// half-angle formula until the series has converged.
fn half_angle(y: f64, x: f64) -> f64 {
    let (mut tangent, mut turns) = (y / x, 1.0);
    while tangent > 1e-3 {
        tangent /= 1.0 + (1.0 + tangent * tangent).sqrt();
        turns *= 2.0;
    }
    let square = tangent * tangent;
    turns * tangent * (1.0 - square / 3.0 + square * square / 5.0)
}

/// LS-01: the solid angle of a ball, from close by to the far end of what `f32` can hold.
pub(super) const CAP: Case = Case {
    id: "LS-01",
    chapter: CHAPTER,
    input: "the solid angle of a ball, at 1 to 10^18 of its radius",
    most: UNLIMITED,
    naive_fails: |trial| is_not_solid_angle(distance(trial), naive::solid_angle(distance(trial))),
    robust_fails: |trial| {
        let cap = Cap::of_ball(distance(trial));
        cap.is_none_or(|cap| is_not_solid_angle(distance(trial), cap.solid_angle()))
    },
};

fn distance(trial: u64) -> f32 {
    let mut stream = Stream::of_trial(1108, trial);
    let far = common::math::pow(10.0, stream.between(0.0, 18.0));
    // A quarter are close: 1 + 10⁻⁶ and more.
    let near = 1.0 + common::math::pow(10.0, stream.between(-6.0, 0.0));
    (if trial.is_multiple_of(4) { near } else { far }).max(1.0f32.next_up())
}

/// 2π (1 - cos), with 1 - cos = sin² / (1 + cos) and cos² = (d - 1)(d + 1) / d², in `f64`.
fn is_not_solid_angle(distance: f32, found: f32) -> bool {
    let distance = f64::from(distance);
    let cosine = ((distance - 1.0) * (distance + 1.0)).sqrt() / distance;
    let right = std::f64::consts::TAU / (distance * distance) / (1.0 + cosine);
    // Five roundings in a row.
    !((f64::from(found) / right - 1.0).abs() <= 5.0 * f64::from(f32::EPSILON))
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec2;

    use super::half_angle;
    use crate::warp::hemisphere;

    #[test]
    fn the_oracle_knows_eighths_of_a_turn() {
        assert!((half_angle(1.0, 1.0) - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
        assert_eq!(half_angle(0.0, 1.0), 0.0);
    }

    /// MC-02, all of the edge: 2²⁴ places on each of two sides.
    #[test]
    fn no_place_of_the_edge_fails() {
        for place in (0..1 << 24).step_by(16) {
            let along = place as f32 / (1 << 24) as f32;
            for u in [Vec2::new(0.0, along), Vec2::new(along, 0.0)] {
                let direction = hemisphere::cosine(u);
                assert!(direction.z > 0.0 && hemisphere::cosine_density(direction.z) > 0.0);
            }
        }
        let some = hemisphere::cosine(Stream::of_trial(1, 1).uniform2()).as_dvec3();
        assert!((some.length() - 1.0).abs() < 1e-6);
    }
}
