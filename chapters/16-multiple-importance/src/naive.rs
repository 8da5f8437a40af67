//! The textbook's formulas and estimators that are wrong: right on paper, or nearly.
//!
//! They are kept to be looked at, and as the negative controls of tests and hard cases.

use common::film::Color;
use common::tally::Tally;
use glam::Vec2;
use light_sampling::by_light::ByLight;
use light_sampling::lights::Lights;
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;
use path_tracing::space::{Met, Space};
use path_tracing::strategy::Lighting;
use path_tracing::vertex::{Departure, Vertex};

use crate::combined::Combined;
use crate::heuristic::Heuristic;
use crate::place::Place;

// ANCHOR: power
/// The power heuristic as it is written.
pub fn power(own: f32, other: f32) -> f32 {
    own * own / (own * own + other * other)
}
// ANCHOR_END: power

// ANCHOR: infinite
/// The same, mended as in a well-known program: where the square has no number, the weight is 1.
pub fn infinite_is_one(own: f32, other: f32) -> f32 {
    let square = own * own;
    if square.is_infinite() { 1.0 } else { square / (square + other * other) }
}
// ANCHOR_END: infinite

// ANCHOR: published
/// The weight of a point that was chosen uniformly over `area`: its density is one over that, and
/// `by_direction` is the density with which the surface would have chosen its direction.
pub fn weight_by_area(area: f32, by_direction: f32) -> f32 {
    let by_light = 1.0 / area;
    by_light / (by_light + by_direction)
}
// ANCHOR_END: published

/// Both estimates of a place, added: all light twice.
pub fn added(place: &Place, [light, direction]: [Vec2; 2]) -> f32 {
    place.by_light(light) + place.by_direction(direction)
}

/// The mean of both. It is right: half and half add up to 1. It keeps a quarter of either's variance,
/// however bad that one is.
pub fn averaged(place: &Place, u: [Vec2; 2]) -> f32 {
    added(place, u) / 2.0
}

// ANCHOR: added
/// Light that is looked for in both ways, and counts in full each time.
#[derive(Clone, Copy, Debug)]
pub struct Added<'a>(pub ByLight<'a>);

impl Lighting for Added<'_> {
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        self.0.direct(space, vertex, random, tally)
    }

    fn share(&self, _departure: &Departure, _met: &Met) -> f32 {
        1.0
    }
}
// ANCHOR_END: added

// ANCHOR: unchosen
/// Weights that don't add up to 1: where a path came upon the lamp, the chance that this lamp is the
/// one to be looked at is forgotten.
#[derive(Clone, Copy, Debug)]
pub struct Unchosen<'a> {
    /// The lamps.
    pub lights: &'a Lights,
    /// How the two ways share.
    pub heuristic: Heuristic,
}

impl Lighting for Unchosen<'_> {
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        let Self { lights, heuristic } = *self;
        Combined { lights, heuristic }.direct(space, vertex, random, tally)
    }

    fn share(&self, departure: &Departure, met: &Met) -> f32 {
        if departure.is_delta {
            return 1.0;
        }
        let chosen = self.lights.probability(met.piece).unwrap_or(1.0);
        self.heuristic.weight(departure.pdf, self.lights.pdf(departure.from, met) / chosen)
    }
}
// ANCHOR_END: unchosen

#[cfg(test)]
mod tests {
    use super::{Heuristic, infinite_is_one, power, weight_by_area};

    #[test]
    fn they_are_right_where_they_are_tried() {
        assert_eq!(power(3.0, 1.0), 0.9);
        assert_eq!(infinite_is_one(3.0, 1.0), 0.9);
        assert_eq!(weight_by_area(0.5, 2.0), 0.5);
    }

    /// *By hand:* half a square metre, two metres off: 8 per steradian, and not 2 per square metre.
    #[test]
    fn by_hand_apples() {
        let by_light = 2.0 * 2.0 / 0.5;
        assert_eq!(
            (Heuristic::Balance.weight(by_light, 2.0), weight_by_area(0.5, 2.0)),
            (0.8, 0.5)
        );
    }

    #[test]
    fn they_are_wrong_where_they_are_needed() {
        assert!(power(1e20, 1.0).is_nan() && power(1e-23, 1e-23).is_nan());
        assert_eq!(infinite_is_one(1e20, 2e20) + infinite_is_one(2e20, 1e20), 2.0);
        assert!(infinite_is_one(1e-23, 1e-23).is_nan());
    }
}
