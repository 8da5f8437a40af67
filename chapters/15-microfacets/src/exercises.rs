//! The exercises of chapter 15: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p microfacets --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 15 has the story of
//! each.

use glam::{Vec2, Vec3};

/// Exercise 15.1, the distribution: D of GGX.
///
/// `alpha` is the roughness, from 10⁻⁴ to 1, and `normal` has length 1 and z above 0. All digits count.
/// See the section "How facets lie".
pub fn density(alpha: f32, normal: Vec3) -> f32 {
    let _ = (alpha, normal);
    todo!("exercise 15.1")
}

/// Exercise 15.2, seen and lit: the height-correlated G₂ of two directions above the surface.
///
/// Both have length 1; `outgoing.z` and `incoming.z` are above 0. See the section "Facets that are
/// hidden".
pub fn seen_and_lit(alpha: f32, outgoing: Vec3, incoming: Vec3) -> f32 {
    let _ = (alpha, outgoing, incoming);
    todo!("exercise 15.2")
}

/// Exercise 15.3, what is seen: a normal with the density of visible normals.
///
/// `outgoing` has length 1 and z above 0; `u` is a uniform point of the unit square. The check takes
/// many normals and asks for their means. See the section "Facets that are seen".
pub fn visible_normal(alpha: f32, outgoing: Vec3, u: Vec2) -> Vec3 {
    let _ = (alpha, outgoing, u);
    todo!("exercise 15.3")
}

/// Exercise 15.4, a whole estimator: one estimate of how much light a surface of roughness 1 sends
/// to a direction whose cosine is `cosine`, when each facet reflects all and radiance 1 comes from
/// everywhere.
///
/// `u` is a uniform point of the unit square. The mean of your estimates must be
/// 1 - cosine ln(1 + 1 / cosine). The check takes many, and does not care how you choose directions.
/// See the section "The light that is lost".
pub fn sent_back(cosine: f32, u: Vec2) -> f32 {
    let _ = (cosine, u);
    todo!("exercise 15.4")
}

/// Exercise 15.5, find the mistake: the density of a reflected direction, per steradian.
///
/// `naive::reflected_density` divides the density of the normal by 4. Give the density of the
/// direction to which a facet with normal `normal` reflects `outgoing`, for `density_of_normal`, the
/// density of that normal. See the section "From normals to directions".
pub fn reflected_density(outgoing: Vec3, normal: Vec3, density_of_normal: f32) -> f32 {
    let _ = (outgoing, normal, density_of_normal);
    todo!("exercise 15.5")
}
