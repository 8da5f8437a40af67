//! The edges of boxes, drawn over a picture.

use common::film::Color;
use glam::DVec3;
use ray_casting::ray::Ray;

use crate::aabb::Aabb;
use crate::oracle::crossing;

/// The colour of an edge that nothing hides.
const WIRE: Color = Color::new(0.03, 0.03, 0.06);

/// `seen` with the edges of the boxes over it: strong where they are before the surface at distance
/// `limit`, faint behind it.
pub(crate) fn over(seen: Color, boxes: &[Aabb], thickness: f32, ray: &Ray, limit: f32) -> Color {
    boxes.iter().fold(seen, |seen, bounds| {
        let Some(distances) = crossing(ray, bounds, 0.0) else { return seen };
        distances.into_iter().filter(|&t| t >= 0.0).fold(seen, |seen, t| {
            let point = ray.origin.as_dvec3() + t * ray.direction.as_dvec3();
            let strength = match () {
                () if !on_edge(point, bounds, f64::from(thickness)) => 0.0,
                () if t <= f64::from(limit) => 0.85,
                () => 0.15,
            };
            seen.lerp(WIRE, strength)
        })
    })
}

/// Whether a point of the box's surface is near two of its faces at right angles.
fn on_edge(point: DVec3, bounds: &Aabb, thickness: f64) -> bool {
    let low = (point - bounds.min.as_dvec3()).abs();
    let high = (point - bounds.max.as_dvec3()).abs();
    let near = low.min(high).cmplt(DVec3::splat(thickness));
    near.bitmask().count_ones() >= 2
}
