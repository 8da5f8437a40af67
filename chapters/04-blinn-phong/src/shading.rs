//! The shading model: what reaches the eye of the light that reaches a surface.

use common::film::Color;
use common::math;
use glam::Vec3;
use ray_casting::shape::Hit;

use crate::light::Arriving;
use crate::material::BlinnPhong;

// ANCHOR: lit
/// What a surface point sends `toward_eye` of one lamp's light: the last two terms of equation 2-1
/// of the report, with the clamps that it leaves out. The normal is turned to the eye's side.
///
/// Blinn, "Models of light reflection for computer synthesized pictures" (SIGGRAPH 1977).
pub fn lit(material: &BlinnPhong, hit: &Hit, toward_eye: Vec3, arriving: &Arriving) -> Color {
    let normal = facing(hit.normal, toward_eye);
    let cosine = normal.dot(arriving.toward).max(0.0);
    if cosine == 0.0 {
        return Color::ZERO;
    }
    let diffuse = cosine * material.diffuse.at(hit.uv);
    let specular = highlight(normal, toward_eye, arriving.toward, material.shininess);
    arriving.color * (diffuse + specular * material.specular)
}
// ANCHOR_END: lit

/// (N · L')ⁿ, where L' is the half vector between the directions to the eye and to the lamp.
fn highlight(normal: Vec3, toward_eye: Vec3, toward_light: Vec3, shininess: f32) -> f32 {
    let half = (toward_eye + toward_light).normalize_or_zero();
    let cosine = normal.dot(half).clamp(0.0, 1.0);
    if shininess > 0.0 { math::pow(cosine, shininess) } else { 0.0 }
}

/// The normal, turned to the side that `toward` is on.
pub fn facing(normal: Vec3, toward: Vec3) -> Vec3 {
    if normal.dot(toward) < 0.0 { -normal } else { normal }
}
