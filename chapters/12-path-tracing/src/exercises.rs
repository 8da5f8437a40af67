//! The exercises of chapter 12: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p path-tracing --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 12 has the story of
//! each.

use common::film::Color;

use crate::naive::Intersection;
use crate::part::Emission;

/// Exercise 12.1, what a direction counts: the weight of a direction that a matte surface chose.
///
/// `reflectance` is the surface's albedo, `cosine` that of the direction's angle to the normal, and
/// `pdf` the density with which the direction was chosen, per steradian. A direction below the
/// surface, or in it, brings nothing. See the section "One path".
pub fn weight(reflectance: f32, cosine: f32, pdf: f32) -> f32 {
    let _ = (reflectance, cosine, pdf);
    todo!("exercise 12.1")
}

/// Exercise 12.2, in the furnace: an estimate from one path that leaves at most `depth` surfaces.
///
/// Every wall emits the radiance 1 and reflects the part `albedo`. Choose directions *uniformly* from
/// the hemisphere: then a direction's cosine is itself a uniform number in [0, 1), such as each call of
/// `random` gives, and its density is 1 / 2π. The room needs no geometry: every ray meets a wall. The
/// check takes many of your estimates. See the section "The furnace".
pub fn furnace(albedo: f32, depth: u32, random: &mut dyn FnMut() -> f32) -> f32 {
    let _ = (albedo, depth, random);
    todo!("exercise 12.2")
}

/// A world of four numbers, for exercise 12.3.
///
/// The eye looks at a matte wall. From every point of it a direction that is chosen as densely as its
/// cosine meets the lamp with the probability `lamp_share`, and the sky with `sky_share`; otherwise it
/// meets wall again. The lamp reflects nothing.
#[derive(Clone, Copy, Debug)]
pub struct Tiny {
    /// The wall's reflectance; the wall doesn't glow.
    pub albedo: f32,
    /// How often the lamp is met.
    pub lamp_share: f32,
    /// The lamp's radiance.
    pub lamp: f32,
    /// How often the sky is met.
    pub sky_share: f32,
    /// The sky's radiance.
    pub sky: f32,
}

/// Exercise 12.3, a whole path tracer: an estimate from one path, which starts on the wall and leaves
/// at most `depth` surfaces.
///
/// Each call of `random` gives a number in [0, 1): use one to find out what a direction meets. See
/// the section "The loop".
pub fn tiny_path(tiny: &Tiny, depth: u32, random: &mut dyn FnMut() -> f32) -> f32 {
    let _ = (tiny, depth, random);
    todo!("exercise 12.3")
}

/// Exercise 12.4, find the mistake: what a camera's ray brings without any light that was reflected.
///
/// `naive::camera_light` is the report's §5.3: it asks what was met for its light before it asks
/// whether anything was met. Things glow on both sides if they say so, else on the side where
/// `outgoing_z` is above 0. Where nothing was met there is the sky. See the section "The loop".
pub fn camera_light(met: &Intersection, things: &[Emission], sky: Color) -> Color {
    let _ = (met, things, sky);
    todo!("exercise 12.4")
}

/// Exercise 12.5, how deep: the smallest depth at which at most the part `missing` of a furnace's
/// light is left out.
///
/// `albedo` is from 0 to below 1, `missing` above 0. A depth of 0 sees what the first surface emits. See
/// the section "Where to stop".
pub fn depth(albedo: f64, missing: f64) -> u32 {
    let _ = (albedo, missing);
    todo!("exercise 12.5")
}
