//! Following one path from the eye.

use common::film::Color;
use common::sampler::Sampler;
use common::tally::{Event, Tally};
use ray_casting::ray::Ray;

use crate::bsdf::Bsdf;
use crate::part::Emission;
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

// ANCHOR: segment
/// One straight piece of a path: on its way from a vertex, or from the eye, to what it will meet.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    /// The ray along it.
    pub ray: Ray,
    /// How the path left the vertex before.
    pub departure: Departure,
    /// What the radiance that comes along it counts at the eye.
    pub throughput: Color,
    /// The surfaces that the path has left already.
    pub bounce: u32,
}

impl Segment {
    /// The first of a path.
    #[inline]
    pub fn from_eye(ray: Ray) -> Self {
        Self { ray, departure: Departure::from_eye(&ray), throughput: Color::ONE, bounce: 0 }
    }
}
// ANCHOR_END: segment

impl<B: Bsdf, L: Lighting, E: Ending, const EMITTERS: bool, const SKY: bool>
    PathTracer<'_, B, L, E, EMITTERS, SKY>
{
    // ANCHOR: radiance
    /// An estimate of the radiance that comes back along the camera's `ray`.
    pub fn radiance<T: Tally>(&self, ray: Ray, sampler: &Sampler, tally: &mut T) -> Color {
        self.follow(Segment::from_eye(ray), sampler, tally)
    }

    /// An estimate of what a path finds that is on its way.
    pub fn follow<T: Tally>(&self, segment: Segment, sampler: &Sampler, tally: &mut T) -> Color {
        let (mut segment, mut radiance) = (segment, Color::ZERO);
        loop {
            let Some(met) = self.world.space.nearest(&segment.ray, tally) else {
                return radiance + segment.throughput * self.sky(tally);
            };
            let surface = &self.world.surfaces[met.owner as usize];
            let vertex = Vertex::new(&segment.ray, &met, &surface.bsdf);
            radiance += self.emitted(&surface.emission, &vertex, &segment, tally);
            let (found, onward) = self.turn(&vertex, &segment, sampler, tally);
            radiance += found;
            let Some(onward) = onward else { return radiance };
            segment = onward;
        }
    }
    // ANCHOR_END: radiance

    // ANCHOR: turn
    /// What is found at the vertex that `segment` led to: the light that is looked for there, as it
    /// counts at the eye, and how the path goes on if it does.
    #[inline]
    fn turn<T: Tally>(
        &self,
        vertex: &Vertex<B>,
        segment: &Segment,
        sampler: &Sampler,
        tally: &mut T,
    ) -> (Color, Option<Segment>) {
        let random = Random::at(sampler, segment.bounce + 1);
        if segment.bounce == self.depth {
            let goes_on = vertex.bsdf.sample(vertex.outgoing, &random).is_some();
            tally.count(TRUNCATED_PATHS, u64::from(goes_on));
            return (Color::ZERO, None);
        }
        let direct = self.direct(vertex, segment, &random, tally);
        (direct, self.onward(vertex, segment, &random, tally))
    }

    /// The light that is looked for, as it counts at the eye.
    #[inline]
    pub fn direct<T: Tally>(
        &self,
        vertex: &Vertex<B>,
        segment: &Segment,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        if !(EMITTERS && vertex.bsdf.spreads()) {
            return Color::ZERO;
        }
        segment.throughput * self.lighting.direct(self.world.space, vertex, random, tally)
    }

    /// How the path goes on, to light that comes by way of other surfaces.
    #[inline]
    pub fn onward<T: Tally>(
        &self,
        vertex: &Vertex<B>,
        segment: &Segment,
        random: &Random,
        tally: &mut T,
    ) -> Option<Segment> {
        let sample = vertex.bsdf.sample(vertex.outgoing, random)?;
        let bounce = segment.bounce + 1;
        let throughput = segment.throughput * sample.weight;
        let throughput = throughput * self.ending.factor(throughput, bounce, random)?;
        if throughput == Color::ZERO {
            return None;
        }
        let (ray, departure) = vertex.leave(&sample)?;
        tally.count(BOUNCES, 1);
        tally.count(SPECULAR_BOUNCES, u64::from(sample.is_delta));
        tally.count(LONGEST_PATH, u64::from(bounce));
        Some(Segment { ray, departure, throughput, bounce })
    }
    // ANCHOR_END: turn

    /// An estimate of what the vertex that `segment` led to sends on of other lamps' light, as it counts
    /// at the eye.
    pub fn reflected<T: Tally>(
        &self,
        vertex: &Vertex<B>,
        segment: &Segment,
        sampler: &Sampler,
        tally: &mut T,
    ) -> Color {
        let (found, onward) = self.turn(vertex, segment, sampler, tally);
        onward.map_or(found, |onward| found + self.follow(onward, sampler, tally))
    }

    /// The light of what `segment` led to, if it is a lamp, as it counts at the eye.
    #[inline]
    pub fn emitted<T: Tally>(
        &self,
        emission: &Emission,
        vertex: &Vertex<B>,
        segment: &Segment,
        tally: &mut T,
    ) -> Color {
        if !(EMITTERS && emission.glows()) {
            return Color::ZERO;
        }
        tally.count(LAMPS_MET, 1);
        let emitted = segment.throughput * emission.towards(vertex.outgoing.z);
        emitted * self.lighting.share(&segment.departure, vertex.met)
    }

    /// The light from all around.
    #[inline]
    pub fn sky<T: Tally>(&self, tally: &mut T) -> Color {
        if !SKY {
            return Color::ZERO;
        }
        tally.count(SKY_SEEN, 1);
        self.world.sky
    }
}

#[cfg(test)]
mod tests;
