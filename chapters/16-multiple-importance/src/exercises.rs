//! The exercises of chapter 16: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p multiple-importance --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 16 has the story of
//! each.

use glam::Vec2;
use path_tracing::vertex::Departure;

use crate::place::Place;

/// Exercise 16.1, shares: the power heuristic, with squares.
///
/// A sample was found with the density `own`; the other strategy would have found it with the density
/// `other`. Both are finite and at least 0, and may be as large or as small as an `f32` can. The shares
/// of both must add up to 1, except where both densities are 0: there neither counts. See the
/// section "Squares that are no numbers".
pub fn power(own: f32, other: f32) -> f32 {
    let _ = (own, other);
    todo!("exercise 16.1")
}

/// Exercise 16.2, one from each: an estimate of the light that leaves `place`, from a direction to its
/// lamp and from one of its lobe, with weights of your choice.
///
/// `light` and `direction` are two random numbers each, uniform in [0, 1). The mean of your estimates
/// must be the right one, and so must their spread: below 1.2 of the right value. The check takes many.
/// Ask `place` for everything: [`Place::sample_light`], [`Place::light_pdf`],
/// [`Place::sample_direction`], [`Place::direction_pdf`], [`Place::arriving`] and
/// [`Place::scattered`]. See the section "Shares that add up to one".
pub fn combined(place: &Place, light: Vec2, direction: Vec2) -> f32 {
    let _ = (place, light, direction);
    todo!("exercise 16.2")
}

/// Exercise 16.3, come upon: the share, by the balance heuristic, of the light of a lamp that a path
/// came upon.
///
/// `departure` says how the path left the surface before. `light_pdf` is the density with which that
/// surface would have looked in this direction: 0 where the lamp is never looked at. See the section
/// "The path tracer".
pub fn share(departure: &Departure, light_pdf: f32) -> f32 {
    let _ = (departure, light_pdf);
    todo!("exercise 16.3")
}

/// Exercise 16.4, one of two: an estimate of the light that leaves `place` from one direction only.
///
/// Where `chance`, uniform in [0, 1), is below 1/2 look at the lamp, else into the lobe; `u` is for that
/// direction. Weigh by both densities: the spread must stay below 1.5 of the right value. Which
/// density does the direction have in all? See the section "Shares that add up to one".
pub fn one_of_two(place: &Place, chance: f32, u: Vec2) -> f32 {
    let _ = (place, chance, u);
    todo!("exercise 16.4")
}

/// Exercise 16.5, find the mistake: the balance heuristic for a point of a lamp that was chosen
/// uniformly over its area.
///
/// `naive::weight_by_area` compares two numbers of different units. `distance` is that of the point,
/// `cosine` that of the angle at the lamp, above 0; `by_direction` is the density, per steradian, with
/// which the surface would have chosen the direction. Give the share of the lamp's sample. See the
/// section "Apples and steradians".
pub fn weight_by_area(area: f32, distance: f32, cosine: f32, by_direction: f32) -> f32 {
    let _ = (area, distance, cosine, by_direction);
    todo!("exercise 16.5")
}
