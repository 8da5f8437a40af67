//! The exercises of chapter 4: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p blinn-phong --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 4 has the story of
//! each.

use common::film::Color;
use glam::{Vec2, Vec3};

use crate::light::Light;

/// Exercise 4.1, Lambert's law: how much light one lamp makes a matte surface return.
///
/// `normal` and `toward_light` have length 1 and lead away from the surface. `diffuse` is k_d, `color`
/// what arrives of the lamp. A lamp behind the surface gives nothing. See "Lambert's law".
pub fn lambert(diffuse: Color, normal: Vec3, toward_light: Vec3, color: Color) -> Color {
    let _ = (diffuse, normal, toward_light, color);
    todo!("exercise 4.1")
}

/// Exercise 4.2, two highlights: how strong Phong's is and how strong Blinn's, in that order.
///
/// All directions have length 1 and lead away from the surface; the lamp and the eye are on the
/// normal's side. `shininess` is above 0. [`common::math::pow`] is the power. See "Phong's highlight"
/// and "Blinn's highlight".
pub fn highlights(normal: Vec3, toward_eye: Vec3, toward_light: Vec3, shininess: f32) -> [f32; 2] {
    let _ = (normal, toward_eye, toward_light, shininess);
    todo!("exercise 4.2")
}

/// Exercise 4.3, a lamp you can stand under: what arrives at `point` of a lamp.
///
/// The direction to the lamp, of length 1, and its colour over 1 + d², where d is the distance. None
/// where the lamp is. Distances go from 10^-30 to 10^15. See "Lamps".
pub fn arriving(lamp: Vec3, color: Color, point: Vec3) -> Option<(Vec3, Color)> {
    let _ = (lamp, color, point);
    todo!("exercise 4.3")
}

/// Exercise 4.4, a paint of your own: stripes.
///
/// `count` stripes from u = 0 to u = 1, all equally wide, the first of `colors[0]`, the next of
/// `colors[1]`, and so on in turn. u = 1 belongs to the last stripe. See "Paint".
pub fn stripes(count: u32, colors: [Color; 2], uv: Vec2) -> Color {
    let _ = (count, colors, uv);
    todo!("exercise 4.4")
}

/// Exercise 4.5, find the mistake: the report's equation 2-1, for any lamps.
///
/// The report prints
///
/// ```text
/// I = I_a + k_d Σ (N · L_j) + k_s Σ (N · L'_j)ⁿ
/// ```
///
/// with no word on what L' is, nothing about lamps behind the surface, and no colour of a lamp. Write
/// it so that it is right. `ambient` is I_a; the highlight is Blinn's. A lamp behind the surface adds
/// nothing to either sum. [`Light::at`] says what arrives at `point`. See "Equation 2-1".
pub fn shade(material: &Plain, lights: &[Light], point: Vec3, normal: Vec3, eye: Vec3) -> Color {
    let _ = (material, lights, point, normal, eye);
    todo!("exercise 4.5")
}

/// The material of exercise 4.5.
#[derive(Clone, Copy, Debug)]
pub struct Plain {
    /// I_a: what the surface returns of the light from everywhere.
    pub ambient: Color,
    /// k_d.
    pub diffuse: Color,
    /// k_s.
    pub specular: Color,
    /// n, above 0, and not always whole.
    pub shininess: f32,
}
