//! The textbook's formulas: right on paper.

use std::f32::consts::PI;

use common::math::{cos, sin};
use glam::{Vec2, Vec3};

// ANCHOR: density
/// D from the cosine of the normal's angle alone, as in most programs.
///
/// Walter, Marschner, Li and Torrance (2007), equation 33, with cos⁴θ multiplied in.
pub fn density(alpha: f32, cosine: f32) -> f32 {
    let square = alpha * alpha;
    let spread = cosine * cosine * (square - 1.0) + 1.0;
    square / (PI * spread * spread)
}
// ANCHOR_END: density

// ANCHOR: masking
/// G₁ by way of tan²θ. Where that is infinite, Λ counts as 0.
pub fn masking(alpha: f32, cosine: f32) -> f32 {
    let squared = cosine * cosine;
    let slope = (1.0 - squared) / squared;
    let lambda =
        if slope.is_finite() { ((1.0 + alpha * alpha * slope).sqrt() - 1.0) / 2.0 } else { 0.0 };
    1.0 / (1.0 + lambda)
}
// ANCHOR_END: masking

// ANCHOR: cook_torrance
/// D G G / (4 z z') as it is printed, without a question about the directions.
pub fn cook_torrance(alpha: f32, outgoing: Vec3, incoming: Vec3) -> f32 {
    let normal = (outgoing + incoming).normalize();
    let both = masking(alpha, outgoing.z) * masking(alpha, incoming.z);
    density(alpha, normal.z) * both / (4.0 * outgoing.z * incoming.z)
}
// ANCHOR_END: cook_torrance

// ANCHOR: heitz
/// A visible normal by way of a point of a disk.
///
/// Heitz, "Sampling the GGX distribution of visible normals" (Journal of Computer Graphics Techniques
/// 7(4), 2018), listing 1.
pub fn visible_normal(alpha: f32, outgoing: Vec3, u: Vec2) -> Vec3 {
    let view = Vec3::new(alpha * outgoing.x, alpha * outgoing.y, outgoing.z).normalize();
    let across = view.x * view.x + view.y * view.y;
    let first =
        if across > 0.0 { Vec3::new(-view.y, view.x, 0.0) / across.sqrt() } else { Vec3::X };
    let second = view.cross(first);
    let (radius, turn) = (u.x.sqrt(), 2.0 * PI * u.y);
    let x = radius * cos(turn);
    let share = 0.5 * (1.0 + view.z);
    let y = (1.0 - share) * (1.0 - x * x).max(0.0).sqrt() + share * radius * sin(turn);
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    let normal = x * first + y * second + z * view;
    Vec3::new(alpha * normal.x, alpha * normal.y, normal.z.max(0.0)).normalize()
}
// ANCHOR_END: heitz

// ANCHOR: caps
/// A visible normal by way of a cap, as published.
///
/// Dupuy and Benyoub, "Sampling visible GGX normals with spherical caps" (2023), listing 3.
pub fn visible_by_cap(alpha: f32, outgoing: Vec3, u: Vec2) -> Vec3 {
    let view = Vec3::new(alpha * outgoing.x, alpha * outgoing.y, outgoing.z).normalize();
    let turn = 2.0 * PI * u.y;
    let z = (1.0 - u.x) * (1.0 + view.z) - view.z;
    let radius = (1.0 - z * z).clamp(0.0, 1.0).sqrt();
    let normal = Vec3::new(radius * cos(turn), radius * sin(turn), z) + view;
    Vec3::new(alpha * normal.x, alpha * normal.y, normal.z).normalize()
}
// ANCHOR_END: caps

// ANCHOR: metal
/// What a conductor reflects, in `f32`: the formula of most programs (Sébastien Lagarde, "Memo on
/// Fresnel equations", 2013).
pub fn metal(n: f32, k: f32, cosine: f32) -> f32 {
    let cosine_squared = cosine * cosine;
    let sine_squared = 1.0 - cosine_squared;
    let rest = n * n - k * k - sine_squared;
    let sum = (rest * rest + 4.0 * n * n * k * k).sqrt();
    let a = (0.5 * (sum + rest)).sqrt();
    let (one, two) = (sum + cosine_squared, 2.0 * cosine * a);
    let perpendicular = (one - two) / (one + two);
    let three = cosine_squared * sum + sine_squared * sine_squared;
    let four = two * sine_squared;
    0.5 * (perpendicular + perpendicular * (three - four) / (three + four))
}
// ANCHOR_END: metal

// ANCHOR: reflected_density
/// The density of a reflected direction, for that of the normal: what comes to mind first. The
/// direction turns by twice the angle of the normal, and in two directions at once that makes 4.
pub fn reflected_density(density_of_normal: f32) -> f32 {
    density_of_normal / 4.0
}
// ANCHOR_END: reflected_density
