//! One good answer to each exercise.

use glam::{Vec2, Vec3};
use multiple_importance::place::Place;

use crate::cases::{Arrival, Pair, Point};

pub(super) fn power(&Pair { own, other }: &Pair) -> f32 {
    if own <= 0.0 {
        return 0.0;
    }
    let ratio = other / own;
    1.0 / (1.0 + ratio * ratio)
}

/// What a direction brings, for each unit of its density.
pub(super) fn brings(place: &Place, incoming: Vec3) -> f32 {
    place.arriving(incoming) * place.scattered(incoming)
}

/// The sum of both densities.
pub(super) fn densities(place: &Place, incoming: Vec3) -> f32 {
    place.light_pdf(incoming) + place.direction_pdf(incoming)
}

/// With the balance heuristic, the density under the fraction is canceled.
pub(super) fn combined(place: &Place, light: Vec2, direction: Vec2) -> f32 {
    let both = [place.sample_light(light), place.sample_direction(direction)];
    both.iter().map(|&incoming| brings(place, incoming) / densities(place, incoming)).sum()
}

pub(super) fn share(it: &Arrival) -> f32 {
    if it.departure.is_delta {
        return 1.0;
    }
    it.departure.pdf / (it.departure.pdf + it.light_pdf)
}

pub(super) fn one_of_two(place: &Place, chance: f32, u: Vec2) -> f32 {
    let incoming = if chance < 0.5 { place.sample_light(u) } else { place.sample_direction(u) };
    brings(place, incoming) / (0.5 * densities(place, incoming))
}

pub(super) fn weight_by_area(&Point { area, distance, cosine, by_direction }: &Point) -> f32 {
    let by_light = distance * distance / (area * cosine);
    by_light / (by_light + by_direction)
}
