//! WH-11 and WH-12: mirrored directions that would run into the mirror.

use common::hard::{Case, UNLIMITED};
use common::math;
use common::sampler::Stream;
use glam::{Vec2, Vec3};
use ray_casting::direction::unit;
use ray_casting::shape::Hit;

use super::{CHAPTER, across, direction};
use crate::mirror::{leaving, reflect};

/// WH-11: the smooth normal of a coarse mesh leans away from the triangle's own.
pub(super) const SMOOTH: Case = Case {
    id: "WH-11",
    chapter: CHAPTER,
    input: "a mirror whose smooth normal leans by up to 30 degrees",
    most: UNLIMITED,
    naive_fails: |trial| enters(&leaning(trial), textbook),
    robust_fails: |trial| enters(&leaning(trial), leaving),
};

/// WH-12: a flat mirror, and a ray that all but runs along it.
pub(super) const GRAZING: Case = Case {
    id: "WH-12",
    chapter: CHAPTER,
    input: "a flat mirror met at 1e-9 to 1e-5 radians",
    most: UNLIMITED,
    naive_fails: |trial| enters(&grazing(trial), textbook),
    robust_fails: |trial| enters(&grazing(trial), leaving),
};

/// The textbook's direction, given its length again.
fn textbook(incoming: Vec3, hit: &Hit) -> Option<Vec3> {
    unit(reflect(incoming, hit.normal))
}

/// A ray that came in, and what it met.
struct Mirrored {
    incoming: Vec3,
    hit: Hit,
}

/// Whether the direction doesn't leave the side that the ray came from, or isn't near the horizon
/// though the plain mirror's direction is below it, or isn't the plain mirror's though that is fine.
fn enters(Mirrored { incoming, hit }: &Mirrored, formula: fn(Vec3, &Hit) -> Option<Vec3>) -> bool {
    let Some(way) = formula(*incoming, hit) else { return true };
    let (incoming, normal) = (incoming.as_dvec3(), hit.normal.as_dvec3().normalize());
    let geometric = hit.geometric.as_dvec3().normalize();
    let outward = -geometric * incoming.dot(geometric).signum();
    let exact = (incoming - 2.0 * incoming.dot(normal) * normal).normalize();

    // What is below the horizon is lifted onto it; the roundings of f32 are well below 2e-6.
    let lifted = (exact - exact.dot(outward).min(0.0) * outward).normalize();
    let way = way.as_dvec3();
    !(way.dot(outward) > 0.0 && (way - lifted).length() <= 4e-6)
}

/// A ray from the front of a triangle, and a normal up to 30 degrees from the triangle's own.
fn leaning(trial: u64) -> Mirrored {
    let mut stream = Stream::of_trial(611, trial);
    let geometric = direction(&mut stream);
    let lean = 0.57 * stream.uniform() * across(&mut stream, geometric);
    let normal = unit(geometric + lean).unwrap_or(geometric);
    let from = geometric * stream.between(0.01, 1.0) + across(&mut stream, geometric);
    Mirrored { incoming: unit(-from).unwrap_or(-geometric), hit: hit(geometric, normal) }
}

/// A ray that comes down on a mirror at a grazing angle.
fn grazing(trial: u64) -> Mirrored {
    let mut stream = Stream::of_trial(612, trial);
    let normal = direction(&mut stream);
    let angle = math::pow(10.0, stream.between(-9.0, -5.0));
    let along = across(&mut stream, normal);
    Mirrored { incoming: unit(along - angle * normal).unwrap_or(along), hit: hit(normal, normal) }
}

fn hit(geometric: Vec3, normal: Vec3) -> Hit {
    let (point, error) = (Vec3::ZERO, Vec3::ZERO);
    Hit { t: 1.0, point, error, geometric, normal, uv: Vec2::ZERO }
}
