//! What a ray can hit.

use std::borrow::Borrow;

use common::tally::{Counts, Event, Tally};
use glam::{Vec2, Vec3};

use crate::ray::Ray;

/// Questions asked of a shape: does this ray hit you?
pub const SHAPE_TESTS: Event = Event::new(1, 1, "shape_tests");

// ANCHOR: hit
/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// How far along the ray, in lengths of its direction.
    pub t: f32,
    /// The point on the surface.
    pub point: Vec3,
    /// How far from the surface `point` may be along each axis, for the roundings on its way, and
    /// those of asking the shape again from beside it.
    pub error: Vec3,
    /// The surface's own outward normal there, of length 1, whichever side the ray comes from.
    pub geometric: Vec3,
    /// The normal the surface is to be shaded with, of length 1: the surface's own, but for meshes
    /// that are to look smooth.
    pub normal: Vec3,
    /// Where on the surface, in its own coordinates, each in [0, 1].
    pub uv: Vec2,
}
// ANCHOR_END: hit

// ANCHOR: shape
/// A surface that rays can hit.
pub trait Shape: Send + Sync {
    /// The first hit with `0 < t < t_max`, if there is one.
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit>;
    // ANCHOR_END: shape

    /// Whether there is any hit with `0 < t < t_max`. A shape of many parts may stop at the first.
    fn is_hit(&self, ray: &Ray, t_max: f32) -> bool {
        self.hit(ray, t_max).is_some()
    }

    /// The same as `hit`, with its work counted. A shape made of many parts counts each of them.
    fn hit_counted(&self, ray: &Ray, t_max: f32, counts: &mut Counts) -> Option<Hit> {
        counts.count(SHAPE_TESTS, 1);
        self.hit(ray, t_max)
    }

    /// The same as `is_hit`, with its work counted.
    fn is_hit_counted(&self, ray: &Ray, t_max: f32, counts: &mut Counts) -> bool {
        counts.count(SHAPE_TESTS, 1);
        self.is_hit(ray, t_max)
    }

    /// Whether a part of it that can be seen from `eye` may be hidden behind the rest of it from
    /// something on the seen side of that part. Few shapes can rule it out.
    fn hides_itself(&self, _eye: Vec3) -> bool {
        true
    }
}

// ANCHOR: nearest
/// The nearest hit among `shapes`, and which of them it is on.
///
/// Each hit found becomes the limit for the shapes after it. Of two hits at the same distance the
/// earlier shape's stands.
pub fn nearest<'a, S: Borrow<dyn Shape>, T: Tally>(
    shapes: &'a [S],
    ray: &Ray,
    tally: &mut T,
) -> Option<Nearest<'a, S>> {
    let mut nearest: Option<Nearest<S>> = None;
    for (index, object) in shapes.iter().enumerate() {
        let limit = nearest.as_ref().map_or(f32::INFINITY, |nearest| nearest.hit.t);
        let shape = object.borrow();
        let hit = match tally.counts() {
            Some(counts) => shape.hit_counted(ray, limit, counts),
            None => shape.hit(ray, limit),
        };
        nearest = hit.map(|hit| Nearest { hit, index, object }).or(nearest);
    }
    nearest
}
// ANCHOR_END: nearest

/// A hit, and what it is on.
#[derive(Debug)]
pub struct Nearest<'a, S> {
    /// The hit.
    pub hit: Hit,
    /// The object's place in the list.
    pub index: usize,
    /// The shape, or what has it.
    pub object: &'a S,
}

#[cfg(test)]
mod tests {
    use common::tally::{Counts, Off};
    use glam::Vec3;

    use super::{SHAPE_TESTS, Shape, nearest};
    use crate::plane::Plane;
    use crate::ray::Ray;
    use crate::sphere::Sphere;

    fn sphere(z: f32, radius: f32) -> Box<dyn Shape> {
        Box::new(Sphere { center: Vec3::new(0.0, 0.0, z), radius })
    }

    const AHEAD: Ray = Ray { origin: Vec3::ZERO, direction: Vec3::NEG_Z };

    #[test]
    fn the_nearest_in_whichever_order() {
        let wall = Plane::new(Vec3::NEG_Z * 9.0, Vec3::Z).expect("a plane");
        let mut shapes =
            vec![sphere(-7.0, 1.5), sphere(-4.0, 0.5), Box::new(wall), sphere(3.0, 2.0)];
        for _ in 0..shapes.len() {
            let found = nearest(&shapes, &AHEAD, &mut Off).expect("a hit");
            assert_eq!(found.hit.t, 3.5);
            let counted = nearest(&shapes, &AHEAD, &mut Counts::default()).expect("a hit");
            assert_eq!((counted.index, counted.hit), (found.index, found.hit));
            assert_eq!(found.object.hit(&AHEAD, f32::INFINITY), Some(found.hit));
            for shape in &shapes {
                let hit = |t_max| shape.hit(&AHEAD, t_max).is_some();
                assert_eq!(
                    [4.0, 50.0].map(|t_max| shape.is_hit(&AHEAD, t_max)),
                    [4.0, 50.0].map(hit)
                );
            }
            shapes.rotate_left(1);
        }
    }

    #[test]
    fn the_earlier_of_two_at_the_same_distance() {
        let shapes = [sphere(-5.0, 2.0), sphere(-6.0, 3.0)];
        let found = nearest(&shapes, &AHEAD, &mut Off).expect("a hit");
        assert_eq!((found.index, found.hit.t), (0, 3.0));
    }

    #[test]
    fn every_question_is_counted() {
        let mut counts = Counts::default();
        assert!(nearest(&[sphere(4.0, 1.0), sphere(5.0, 1.0)], &AHEAD, &mut counts).is_none());
        assert_eq!(counts.of(SHAPE_TESTS), 2);
    }
}
