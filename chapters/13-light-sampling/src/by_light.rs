//! Looking for light where lamps are.

use common::film::Color;
use common::tally::{Event, Tally};
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;
use path_tracing::space::{Met, Space};
use path_tracing::strategy::Lighting;
use path_tracing::vertex::{Departure, Vertex};
use shadows::visibility::{End, visible};

use crate::lights::{LightSample, Lights};

/// Points of lamps that were looked at.
pub const LIGHT_SAMPLES: Event = Event::new(13, 0, "light_samples");

// ANCHOR: by_light
/// Light straight from lamps is found by looking at points of them, and by nothing else: where a
/// path comes upon a lamp by itself, that light has been counted already. It counts only where it
/// could not be looked for: from the eye, and from mirrors and glass (the report's erratum 5).
#[derive(Clone, Copy, Debug)]
pub struct ByLight<'a> {
    /// The lamps.
    pub lights: &'a Lights,
}

impl Lighting for ByLight<'_> {
    #[inline]
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        match self.lights.sample(vertex.hit().point, random) {
            Some(sample) => arriving(space, vertex, &sample, tally) / sample.pdf,
            None => Color::ZERO,
        }
    }

    #[inline]
    fn share(&self, departure: &Departure, met: &Met) -> f32 {
        if departure.is_delta || !self.lights.can_choose(met.piece) { 1.0 } else { 0.0 }
    }
}
// ANCHOR_END: by_light

// ANCHOR: arriving
/// What leaves `vertex` towards the eye of the light of a lamp's point, per steradian of it: nothing
/// if something is in between.
#[inline]
pub fn arriving<B: Bsdf, T: Tally>(
    space: &Space,
    vertex: &Vertex<B>,
    sample: &LightSample,
    tally: &mut T,
) -> Color {
    tally.count(LIGHT_SAMPLES, 1);
    let incoming = vertex.frame.to_local(sample.point.direction);
    let part = vertex.bsdf.eval(vertex.outgoing, incoming) * incoming.z.abs();
    // A shadow ray is the dearest part of it: none where nothing would come of it.
    if part == Color::ZERO || !visible(space, End::On(vertex.hit()), End::On(sample.hit()), tally) {
        return Color::ZERO;
    }
    part * sample.radiance
}
// ANCHOR_END: arriving
