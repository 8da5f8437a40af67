//! WH-06: the length of a direction that is mirrored again and again.

use common::hard::Case;
use common::sampler::Stream;
use glam::{Vec2, Vec3};
use ray_casting::direction::unit;
use ray_casting::shape::Hit;

use super::{CHAPTER, direction};
use crate::mirror::leaving;
use crate::naive;

/// Mirrors that a ray meets in one trial.
const MIRRORS: usize = 1000;

/// WH-06: a thousand mirrors, their normals each right to 2 ε.
pub(super) const DRIFT: Case = Case {
    id: "WH-06",
    chapter: CHAPTER,
    input: "a direction after a thousand mirrors",
    most: 20_000,
    naive_fails: |trial| {
        length_is_lost(trial, |incoming, hit| naive::drifting(incoming, hit.normal))
    },
    robust_fails: |trial| {
        length_is_lost(trial, |incoming, hit| leaving(incoming, hit).unwrap_or(Vec3::NAN))
    },
};

/// Whether the length is not 1, to the 2 ε that chapter 1's `unit` keeps.
fn length_is_lost(trial: u64, reflected: impl Fn(Vec3, &Hit) -> Vec3) -> bool {
    let mut stream = Stream::of_trial(601, trial);
    // Two that face one another, not quite parallel, as in a hall of mirrors.
    let one = direction(&mut stream);
    let other = unit(-one + 0.01 * direction(&mut stream)).unwrap_or(-one);
    let mut way = unit(one + 0.3 * direction(&mut stream)).unwrap_or(one);
    for mirror in [other, one].into_iter().cycle().take(MIRRORS) {
        // The side that the ray comes from, wherever it drifted.
        let normal = if way.dot(mirror) > 0.0 { -mirror } else { mirror };
        way = reflected(way, &met(normal));
    }
    let error = (way.as_dvec3().length() - 1.0).abs();
    !(error <= 2.0 * f64::from(f32::EPSILON))
}

fn met(normal: Vec3) -> Hit {
    let (point, error) = (Vec3::ZERO, Vec3::ZERO);
    Hit { t: 1.0, point, error, geometric: normal, normal, uv: Vec2::ZERO }
}
