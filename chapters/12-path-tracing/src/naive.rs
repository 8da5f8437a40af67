//! The textbook's formulas: right on paper, or nearly.

use common::film::Color;
use common::sampler::Stream;
use common::tally::Off;
use glam::{Vec2, Vec3};
use monte_carlo::frame::Frame;
use monte_carlo::warp::{disk, hemisphere};
use ray_casting::ray::Ray;

use crate::bsdf::{Bsdf, BsdfSample};
use crate::part::Emission;
use crate::vertex::Vertex;
use crate::world::World;

// ANCHOR: cosine
/// One path through uniform directions, which weighs each with f / pdf: the cosine is forgotten.
pub fn without_cosine<B: Bsdf>(
    world: &World<B>,
    ray: Ray,
    depth: u32,
    stream: &mut Stream,
) -> Color {
    let (mut ray, mut radiance, mut throughput) = (ray, Color::ZERO, Color::ONE);
    for _ in 0..=depth {
        let Some(met) = world.space.nearest(&ray, &mut Off) else { break };
        let surface = &world.surfaces[met.owner as usize];
        let vertex = Vertex::new(&ray, &met, &surface.bsdf);
        radiance += throughput * surface.emission.towards(vertex.outgoing.z);

        let up = hemisphere::uniform(stream.uniform2());
        let incoming = up.with_z(up.z.copysign(vertex.outgoing.z));
        let weight = surface.bsdf.eval(vertex.outgoing, incoming) / hemisphere::UNIFORM;
        let pdf = hemisphere::UNIFORM;
        let sample = BsdfSample { incoming, weight, pdf, is_delta: false };
        throughput *= weight;
        let Some((onward, _)) = vertex.leave(&sample) else { break };
        ray = onward;
    }
    radiance
}
// ANCHOR_END: cosine

// ANCHOR: products
/// What a path carries, as equation 4-3 is printed: the product of all f · cosine, divided by the
/// product of all densities. Each step is (f · cosine, density).
pub fn quotient_of_products(steps: &[(f32, f32)]) -> f32 {
    let numerator: f32 = steps.iter().map(|(value, _)| value).product();
    let denominator: f32 = steps.iter().map(|(_, density)| density).product();
    numerator / denominator
}
// ANCHOR_END: products

// ANCHOR: faint
/// How many surfaces a path leaves until it carries less than a thousandth; it has no other end. `None`
/// after `patience` of them.
pub fn surfaces_until_faint(albedo: f32, patience: u32) -> Option<u32> {
    let mut throughput = 1.0;
    (1..=patience).find(|_| {
        throughput *= albedo;
        throughput < 1e-3
    })
}
// ANCHOR_END: faint

// ANCHOR: black
/// The mean of a pixel's samples, those that are no numbers painted black.
pub fn mean_with_black(samples: &[Color]) -> Color {
    let sum: Color =
        samples.iter().map(|sample| if sample.is_nan() { Color::ZERO } else { *sample }).sum();
    sum / samples.len() as f32
}
// ANCHOR_END: black

// ANCHOR: weight
/// A direction as dense as its cosine, from a point of the disk and no more thought.
pub fn cosine_direction(u: Vec2) -> Vec3 {
    let point = disk::concentric(u);
    point.extend((1.0 - point.length_squared()).max(0.0).sqrt())
}

/// The weight f · cosine / pdf of that direction, with the cosine of the world's vectors and the density
/// of the local ones.
pub fn weight(reflectance: f32, frame: &Frame, local: Vec3) -> f32 {
    let cosine = frame.to_world(local).dot(frame.normal).max(0.0);
    let pdf = hemisphere::cosine_density(local.z);
    reflectance / std::f32::consts::PI * cosine / pdf
}
// ANCHOR_END: weight

// ANCHOR: record
/// What a ray met, in a record that is there even when it met nothing, as in GAMES101's framework.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Intersection {
    /// Whether anything was met.
    pub happened: bool,
    /// The number of the thing that was met; 0 where nothing was.
    pub thing: usize,
    /// The height of the direction to the eye over the thing's surface.
    pub outgoing_z: f32,
}

/// What a camera's ray brings without any light that was reflected, in the order of the report's §5.3:
/// first what is met is asked for its light, then whether anything was met.
pub fn camera_light(met: &Intersection, things: &[Emission], sky: Color) -> Color {
    let emission = things[met.thing];
    if emission.glows() {
        return emission.radiance;
    }
    if !met.happened {
        return sky;
    }
    Color::ZERO
}
// ANCHOR_END: record

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::{Vec2, Vec3};
    use monte_carlo::frame::Frame;

    use super::{
        Intersection, camera_light, cosine_direction, mean_with_black, quotient_of_products,
        surfaces_until_faint, weight,
    };
    use crate::part::Emission;

    #[test]
    fn each_is_right_where_nothing_is_hard() {
        assert_eq!(quotient_of_products(&[(0.1, 0.2), (0.3, 0.6)]), 0.25);
        assert_eq!(surfaces_until_faint(0.5, 100), Some(10), "2^-10 is below a thousandth");
        let samples = [Color::splat(1.0), Color::splat(3.0)];
        assert_eq!(mean_with_black(&samples), Color::splat(2.0));
        let local = cosine_direction(Vec2::new(0.4, 0.7));
        assert!((local.length() - 1.0).abs() < 1e-6);
        let frame = Frame::around(Vec3::new(0.6, 0.0, -0.8));
        assert!((weight(0.5, &frame, local) - 0.5).abs() < 1e-6);
    }

    #[test]
    fn the_sky_shines_like_the_first_thing() {
        let lamp = Emission { radiance: Color::splat(7.0), both_sides: false };
        let things = [lamp, Emission::default()];
        let wall = Intersection { happened: true, thing: 1, outgoing_z: 1.0 };
        let sky = Color::splat(0.25);
        assert_eq!(camera_light(&wall, &things, sky), Color::ZERO);
        assert_eq!(camera_light(&Intersection::default(), &things, sky), lamp.radiance);
    }
}
