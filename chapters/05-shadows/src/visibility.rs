//! Whether two points see each other.

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
#[inline]
pub fn between(one: End, other: End) -> Ray {
    match (one, other) {
        (End::On(one), End::On(other)) => between_hits(one, other),
        (End::On(hit), End::Free(point)) | (End::Free(point), End::On(hit)) => {
            let origin = spawn(hit, point - hit.point);
            Ray { origin, direction: point - origin }
        }
        (End::Free(one), End::Free(other)) => {
            let (start, end) = if is_after(one, other) { (other, one) } else { (one, other) };
            Ray { origin: start, direction: end - start }
        }
    }
}

/// The same between two points of surfaces.
#[inline(always)]
pub fn between_hits(one: &Hit, other: &Hit) -> Ray {
    let swapped = is_after(one.point, other.point);
    let (start, end) = (either(swapped, other, one), either(swapped, one, other));
    let way = end.point - start.point;
    // No less than the length, which could overflow.
    let distance = 2.0 * way.abs().max_element();
    let origin = spawn(&start, way);
    Ray { origin, direction: spawn_far(&end, -way, distance) - origin }
}
// ANCHOR_END: between

/// One of two, number by number.
#[inline(always)]
fn either(is_first: bool, first: &Hit, second: &Hit) -> Hit {
    let pick = |first: Vec3, second: Vec3| {
        let pick = |first, second| if is_first { first } else { second };
        Vec3::new(pick(first.x, second.x), pick(first.y, second.y), pick(first.z, second.z))
    };
    Hit {
        point: pick(first.point, second.point),
        error: pick(first.error, second.error),
        geometric: pick(first.geometric, second.geometric),
        ..*first
    }
}

/// Whether one point comes after another: by x, then y, then z. In one go, for a processor guesses
/// wrong as often as not which it is.
#[inline(always)]
fn is_after(one: Vec3, other: Vec3) -> bool {
    let later = |one: f32, other: f32, rest: bool| {
        let (one, other) = (ordered(one), ordered(other));
        (one > other) | ((one == other) & rest)
    };
    let by_z = later(one.z, other.z, false);
    later(one.x, other.x, later(one.y, other.y, by_z))
}

/// An integer in the order of [`f32::total_cmp`].
#[inline(always)]
fn ordered(number: f32) -> i32 {
    let bits = number.to_bits() as i32;
    bits ^ ((bits >> 31) as u32 >> 1) as i32
}

#[cfg(test)]
mod tests {
    use common::tally::{Counts, Off};
    use glam::Vec3;
    use ray_casting::quad::Quad;
    use ray_casting::ray::Ray;
    use ray_casting::shape::{Hit, SHAPE_TESTS, Shape};
    use ray_casting::sphere::Sphere;

    use super::{BLOCKED_RAYS, End, SHADOW_RAYS, between, open, visible};

    /// A floor at y = -1, and a ball of radius 1 at (0, 3, -2).
    fn scene() -> [Box<dyn Shape>; 2] {
        let edges = [Vec3::X * 20.0, Vec3::NEG_Z * 16.0];
        let floor = Quad::new(Vec3::new(-10.0, -1.0, 8.0), edges).expect("an area");
        [Box::new(floor), Box::new(Sphere { center: Vec3::new(0.0, 3.0, -2.0), radius: 1.0 })]
    }

    fn floor_at(x: f32, z: f32) -> Hit {
        let ray = Ray { origin: Vec3::new(x, 1.0, z), direction: Vec3::NEG_Y };
        scene()[0].hit(&ray, f32::INFINITY).expect("it is on the floor")
    }

    #[test]
    fn a_ball_hides_the_lamp_behind_it_and_no_other() {
        let sees = |x, lamp: [f32; 3]| {
            let (hit, lamp) = (floor_at(x, -2.0), End::Free(lamp.into()));
            visible(&scene()[..], End::On(&hit), lamp, &mut Off)
        };
        assert!(!sees(0.0, [0.0, 9.0, -2.0]), "the ball is in between");
        assert!(sees(3.0, [3.0, 9.0, -2.0]), "beside");
        assert!(sees(0.0, [0.0, 1.5, -2.0]), "the ball is behind the lamp");
        assert!(sees(0.0, [0.0, -3.0, -2.0]), "below, where the ray starts below");
    }

    #[test]
    fn a_lamp_far_away_has_no_end() {
        let hit = floor_at(0.0, -2.0);
        assert!(!open(&scene()[..], &hit, Vec3::Y, &mut Off));
        assert!(open(&scene()[..], &hit, Vec3::new(0.9, 0.3, 0.0), &mut Off));
    }

    #[test]
    fn every_ray_is_counted_and_the_first_hit_ends_it() {
        let mut counts = Counts::default();
        let hit = floor_at(0.0, -2.0);
        for y in [9.0, 1.5] {
            visible(&scene()[..], End::On(&hit), End::Free(Vec3::new(0.0, y, -2.0)), &mut counts);
        }
        assert_eq!((counts.of(SHADOW_RAYS), counts.of(BLOCKED_RAYS)), (2, 1));
        let mut reversed = scene();
        reversed.reverse();
        let mut counts = Counts::default();
        visible(&reversed[..], End::On(&hit), End::Free(Vec3::new(0.0, 9.0, -2.0)), &mut counts);
        assert_eq!(counts.of(SHAPE_TESTS), 1, "the ball comes first, and the floor is not asked");
    }

    #[test]
    fn both_ends_ask_about_the_same_ray() {
        let (one, other) = (floor_at(2.5, -1.0), floor_at(-3.0, 4.0));
        let free = End::Free(Vec3::new(0.3, 7.0, 1.0));
        for (one, other) in [(End::On(&one), End::On(&other)), (End::On(&one), free)] {
            assert_eq!(between(one, other), between(other, one));
        }
        let y = between(free, End::On(&one)).origin.y;
        assert!(-1.0 < y && y < -0.999_999, "it starts on the floor, a little above: {y}");
    }

    #[test]
    fn ends_in_one_place_and_ends_that_are_no_numbers_have_an_answer() {
        let hit = floor_at(1.0, 1.0);
        for point in [hit.point, Vec3::NAN, Vec3::INFINITY, Vec3::splat(f32::MAX)] {
            let _answer = visible(&scene()[..], End::On(&hit), End::Free(point), &mut Off);
            assert!(visible(&scene()[..], End::Free(point), End::Free(point), &mut Off));
        }
    }
}
