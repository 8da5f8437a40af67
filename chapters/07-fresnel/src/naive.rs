//! The textbook's formulas: right on paper.

use common::film::Color;
use common::math::{acos, sin, tan};
use glam::Vec3;

// ANCHOR: refract
/// The refracted direction in `f32`, as most programs compute it; None for total reflection.
///
/// `ratio` is n_near / n_far; the normal is on the side the ray comes from. Glassner, "An
/// Introduction to Ray Tracing" (1989), chapter 4.
pub fn refract(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = -direction.dot(normal);
    let k = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (k >= 0.0).then(|| ratio * direction + (ratio * cosine - k.sqrt()) * normal)
}
// ANCHOR_END: refract

// ANCHOR: reflectance
/// What an interface reflects, in `f32` and without a guard.
pub fn reflectance(ratio: f32, cosine: f32) -> f32 {
    let sine = ratio * (1.0 - cosine * cosine).sqrt();
    if sine >= 1.0 {
        return 1.0;
    }
    let far_cosine = (1.0 - sine * sine).sqrt();
    let perpendicular = (ratio * cosine - far_cosine) / (ratio * cosine + far_cosine);
    let parallel = (cosine - ratio * far_cosine) / (cosine + ratio * far_cosine);
    (perpendicular * perpendicular + parallel * parallel) / 2.0
}
// ANCHOR_END: reflectance

// ANCHOR: sines
/// What an interface reflects, as Fresnel wrote it: with sines and tangents of the sum and the
/// difference of both angles.
pub fn by_angles(ratio: f32, cosine: f32) -> f32 {
    let near = acos(cosine);
    let far = acos((1.0 - ratio * ratio * (1.0 - cosine * cosine)).sqrt());
    let perpendicular = sin(near - far) / sin(near + far);
    let parallel = tan(near - far) / tan(near + far);
    (perpendicular * perpendicular + parallel * parallel) / 2.0
}
// ANCHOR_END: sines

// ANCHOR: schlick
/// Schlick's polynomial of the angle on this side, whichever side that is.
pub fn schlick(ratio: f32, cosine: f32) -> f32 {
    let amplitude = (1.0 - ratio) / (1.0 + ratio);
    let straight = amplitude * amplitude;
    let x = 1.0 - cosine;
    straight + (1.0 - straight) * x * x * x * x * x
}
// ANCHOR_END: schlick

// ANCHOR: equation
/// Equation 2-2 of the report: what a surface sends of its own, and k_s of what the mirror's ray
/// brings, and k_t of what the refracted ray brings, both constants of the material.
pub fn equation_2_2(
    own: Color,
    specular: f32,
    mirrored: Color,
    clear: f32,
    refracted: Color,
) -> Color {
    own + specular * mirrored + clear * refracted
}
// ANCHOR_END: equation
