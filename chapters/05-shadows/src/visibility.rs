//! Whether two points see each other.

use std::cmp::Ordering;

use common::tally::{Event, Tally};
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;

use crate::occluder::Occluder;
use crate::spawn::{spawn, spawn_far};

/// Rays that ask whether something is in the way.
pub const SHADOW_RAYS: Event = Event::new(5, 0, "shadow_rays");
/// Those of them that found something.
pub const BLOCKED_RAYS: Event = Event::new(5, 1, "blocked_rays");

// ANCHOR: end
/// One end of a line of sight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End<'a> {
    /// On a surface, which must not be in its own way.
    On(&'a Hit),
    /// In the open, as a lamp without extent.
    Free(Vec3),
}
// ANCHOR_END: end

// ANCHOR: visible
/// Whether nothing of `scene` is between `one` and `other`.
///
/// Light that can go from one end to the other can go back: both orders of the ends ask about the
/// same ray, to the bit. Ends in one place see each other.
pub fn visible<T: Tally>(
    scene: &(impl Occluder + ?Sized),
    one: End,
    other: End,
    tally: &mut T,
) -> bool {
    free(scene, &between(one, other), 1.0, tally)
}

/// Whether nothing of `scene` is on the ray before `t_max`. Every shadow ray is counted here.
pub(crate) fn free<T: Tally>(
    scene: &(impl Occluder + ?Sized),
    ray: &Ray,
    t_max: f32,
    tally: &mut T,
) -> bool {
    let blocked = scene.blocks(ray, t_max, tally);
    tally.count(SHADOW_RAYS, 1);
    tally.count(BLOCKED_RAYS, u64::from(blocked));
    !blocked
}
// ANCHOR_END: visible

/// Whether nothing of `scene` is on the way that leaves the surface at `hit` in `direction`.
pub fn open<T: Tally>(
    scene: &(impl Occluder + ?Sized),
    hit: &Hit,
    direction: Vec3,
    tally: &mut T,
) -> bool {
    free(scene, &Ray { origin: spawn(hit, direction), direction }, f32::INFINITY, tally)
}

// ANCHOR: between
/// The ray from one end, at t = 0, to the other, at t = 1.
///
/// It starts on the surface if one end is free. Between two of a kind it starts at the one with the
/// smaller coordinates, whichever was named first.
pub fn between(one: End, other: End) -> Ray {
    let (start, end) = if starts_at(&one, &other) { (one, other) } else { (other, one) };
    let way = end.point() - start.point();
    // No less than the length, which could overflow.
    let distance = 2.0 * way.abs().max_element();
    let origin = match start {
        End::On(hit) => spawn(hit, way),
        End::Free(point) => point,
    };
    let target = match end {
        End::On(hit) => spawn_far(hit, -way, distance),
        End::Free(point) => point,
    };
    Ray { origin, direction: target - origin }
}

/// Whether the ray between two ends starts at `one`.
fn starts_at(one: &End, other: &End) -> bool {
    match (one, other) {
        (End::On(_), End::Free(_)) => true,
        (End::Free(_), End::On(_)) => false,
        _ => compare(one.point(), other.point()) != Ordering::Greater,
    }
}
// ANCHOR_END: between

/// Which of two points comes first: by x, then y, then z.
fn compare(one: Vec3, other: Vec3) -> Ordering {
    let (one, other) = (one.to_array(), other.to_array());
    let axes = one.iter().zip(&other);
    axes.map(|(one, other)| one.total_cmp(other)).find(|it| it.is_ne()).unwrap_or(Ordering::Equal)
}

impl End<'_> {
    /// Where it is.
    pub fn point(&self) -> Vec3 {
        match self {
            Self::On(hit) => hit.point,
            Self::Free(point) => *point,
        }
    }
}
