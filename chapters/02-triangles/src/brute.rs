//! Brute force: every ray is tested against every triangle.

use std::borrow::Borrow;

use common::tally::Event;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::intersect::{TriangleHit, TriangleTest};

/// Questions asked of a triangle: does this ray hit you?
pub const TRIANGLE_TESTS: Event = Event::new(2, 0, "triangle_tests");

/// A hit, and the triangle it is on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// The hit.
    pub hit: TriangleHit,
    /// The triangle's place in the list.
    pub index: usize,
}

// ANCHOR: nearest
/// The nearest hit with `0 < t < t_max` among all `triangles`.
///
/// Each hit found becomes the limit for the triangles after it. Of two hits at the same distance
/// the earlier triangle's stands.
pub fn nearest<Test: TriangleTest>(
    triangles: impl IntoIterator<Item = impl Borrow<[Vec3; 3]>>,
    ray: &Ray,
    t_max: f32,
) -> Option<Found> {
    let test = Test::prepare(ray)?;
    let mut nearest = None;
    let mut limit = t_max;
    for (index, corners) in triangles.into_iter().enumerate() {
        if let Some(hit) = test.hit(corners.borrow(), limit) {
            limit = hit.t;
            nearest = Some(Found { hit, index });
        }
    }
    nearest
}
// ANCHOR_END: nearest
