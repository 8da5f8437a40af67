//! Following one path from the eye.

use common::film::Color;
use common::sampler::Sampler;
use common::tally::{Event, Tally};
use ray_casting::ray::Ray;

use crate::bsdf::Bsdf;
use crate::random::Random;
use crate::strategy::{Ending, Lighting};
use crate::vertex::{Departure, Vertex};
use crate::world::World;

/// Rays that leave a surface.
pub const BOUNCES: Event = Event::new(12, 0, "bounces");
/// Times a path came upon a lamp.
pub const LAMPS_MET: Event = Event::new(12, 1, "lamps_met");
/// Paths that left the scene and saw the sky.
pub const SKY_SEEN: Event = Event::new(12, 2, "sky_seen");
/// Bounces off mirrors, and off or through glass.
pub const SPECULAR_BOUNCES: Event = Event::new(12, 3, "specular_bounces");
/// Paths that were cut off by the depth.
pub const TRUNCATED_PATHS: Event = Event::new(12, 4, "truncated_paths");
/// The most bounces of a path.
pub const LONGEST_PATH: Event = Event::record(12, 0, "longest_path");

// ANCHOR: tracer
/// A scene, and how paths through it are made. `EMITTERS` and `SKY` say whether anything glows and
/// whether light comes from all around: what is left out is left out of the code.
#[derive(Clone, Debug)]
pub struct PathTracer<'a, B, L, E, const EMITTERS: bool, const SKY: bool> {
    /// The scene.
    pub world: &'a World<'a, B>,
    /// How light is looked for.
    pub lighting: L,
    /// When a path ends.
    pub ending: E,
    /// The most surfaces a path may leave.
    pub depth: u32,
}
// ANCHOR_END: tracer

impl<B: Bsdf, L: Lighting, E: Ending, const EMITTERS: bool, const SKY: bool>
    PathTracer<'_, B, L, E, EMITTERS, SKY>
{
    // ANCHOR: radiance
    /// An estimate of the radiance that comes back along the camera's `ray`.
    pub fn radiance<T: Tally>(&self, ray: Ray, sampler: &Sampler, tally: &mut T) -> Color {
        let (mut ray, mut departure) = (ray, Departure::from_eye(&ray));
        let (mut radiance, mut throughput) = (Color::ZERO, Color::ONE);
        for bounce in 0.. {
            let Some(met) = self.world.space.nearest(&ray, tally) else {
                radiance += throughput * self.sky(tally);
                break;
            };
            let surface = &self.world.surfaces[met.owner as usize];
            let random = Random::at(sampler, bounce + 1);
            let vertex = Vertex::new(&ray, &met, &surface.bsdf);

            // The light that was come upon, and the light that is looked for.
            if EMITTERS && surface.emission.glows() {
                tally.count(LAMPS_MET, 1);
                let emitted = surface.emission.towards(vertex.outgoing.z);
                radiance += throughput * emitted * self.lighting.share(&departure, &met);
            }
            if bounce == self.depth {
                let goes_on = surface.bsdf.sample(vertex.outgoing, &random).is_some();
                tally.count(TRUNCATED_PATHS, u64::from(goes_on));
                break;
            }
            if EMITTERS && surface.bsdf.spreads() {
                let space = self.world.space;
                radiance += throughput * self.lighting.direct(space, &vertex, &random, tally);
            }

            // The light that comes by way of other surfaces.
            let Some(sample) = surface.bsdf.sample(vertex.outgoing, &random) else { break };
            throughput *= sample.weight;
            let Some(factor) = self.ending.factor(throughput, bounce + 1, &random) else { break };
            throughput *= factor;
            if throughput == Color::ZERO {
                break;
            }
            let Some(onward) = vertex.leave(&sample) else { break };
            (ray, departure) = onward;
            tally.count(BOUNCES, 1);
            tally.count(SPECULAR_BOUNCES, u64::from(sample.is_delta));
            tally.count(LONGEST_PATH, u64::from(bounce) + 1);
        }
        radiance
    }
    // ANCHOR_END: radiance

    /// The light from all around.
    #[inline]
    fn sky<T: Tally>(&self, tally: &mut T) -> Color {
        if !SKY {
            return Color::ZERO;
        }
        tally.count(SKY_SEEN, 1);
        self.world.sky
    }
}

#[cfg(test)]
mod tests;
