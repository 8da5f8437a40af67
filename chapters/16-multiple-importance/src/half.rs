//! One of the two parts that make up the light of [`Combined`], to be looked at by itself.

use common::film::Color;
use common::tally::Tally;
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;
use path_tracing::space::{Met, Space};
use path_tracing::strategy::Lighting;
use path_tracing::vertex::{Departure, Vertex};

use crate::combined::Combined;

/// What one of two strategies brings, weighted. Both pictures, added, are that of [`Combined`].
#[derive(Clone, Copy, Debug)]
pub struct Half<'a> {
    /// The whole.
    pub combined: Combined<'a>,
    /// Which part of it.
    pub side: Side,
}

/// One of the two strategies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Light that was found by looking at lamps.
    Light,
    /// Light that paths came upon.
    Direction,
}

impl Lighting for Half<'_> {
    #[inline]
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        match self.side {
            Side::Light => self.combined.direct(space, vertex, random, tally),
            Side::Direction => Color::ZERO,
        }
    }

    #[inline]
    fn share(&self, departure: &Departure, met: &Met) -> f32 {
        match self.side {
            Side::Light => 0.0,
            Side::Direction => self.combined.share(departure, met),
        }
    }
}
