//! What can stand between two points.

use std::borrow::Borrow;

use blinn_phong::scene::Scene;
use common::tally::Tally;
use ray_casting::ray::Ray;
use ray_casting::shape::Shape;

// ANCHOR: occluder
/// Something that can hide things from each other.
pub trait Occluder {
    /// Whether there is any hit with `0 < t < t_max`: the first one found will do, the nearest is
    /// not looked for.
    fn blocks<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> bool;
}
// ANCHOR_END: occluder

// ANCHOR: blocks
/// Shapes, one after the other.
impl<S: Borrow<dyn Shape>> Occluder for [S] {
    fn blocks<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> bool {
        self.iter().map(Borrow::borrow).any(|shape| match tally.counts() {
            Some(counts) => shape.is_hit_counted(ray, t_max, counts),
            None => shape.is_hit(ray, t_max),
        })
    }
}
// ANCHOR_END: blocks

impl<M> Occluder for Scene<M> {
    fn blocks<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> bool {
        self.objects.as_slice().blocks(ray, t_max, tally)
    }
}
