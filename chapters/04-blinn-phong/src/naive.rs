//! The formulas as they are printed, which are right on paper.
//!
//! They are kept to be looked at, and as the negative controls of the hard cases. Nothing else
//! should use them.

use std::f32::consts::PI;

use common::film::Color;
use common::math;
use glam::Vec3;

use crate::light::Arriving;
use crate::material::Surface;
use crate::models::Model;
use crate::shading::facing;

/// The report's equation 2-1, word for word.
pub struct Published;

// ANCHOR: published
impl Model for Published {
    /// (N · L')ⁿ, with L' taken for the half vector as in Whitted (1980).
    fn highlight(normal: Vec3, toward_eye: Vec3, toward_light: Vec3, shininess: f32) -> f32 {
        math::pow(normal.dot(half_vector(toward_eye, toward_light)), shininess)
    }

    /// One term of each sum. Nothing keeps N · L from being negative: a lamp behind the surface
    /// takes light away.
    fn returned(surface: &Surface, normal: Vec3, toward_eye: Vec3, arriving: &Arriving) -> Color {
        let cosine = normal.dot(arriving.toward);
        let strength = Self::highlight(normal, toward_eye, arriving.toward, surface.shininess);
        arriving.color * (cosine * surface.diffuse + strength * surface.specular)
    }
}

/// The direction halfway between two: 0/0 where they are opposite.
pub fn half_vector(toward_eye: Vec3, toward_light: Vec3) -> Vec3 {
    (toward_eye + toward_light).normalize()
}
// ANCHOR_END: published

// ANCHOR: arriving
/// What arrives at `point` of a lamp at a place: 0/0 where the lamp is, and light without end near
/// it.
pub fn arriving(position: Vec3, color: Color, falloff: [f32; 3], point: Vec3) -> Arriving {
    let [constant, linear, quadratic] = falloff;
    let distance = (position - point).length();
    let toward = (position - point) / distance;
    let falloff = constant + linear * distance + quadratic * distance * distance;
    Arriving { toward, distance, color: color / falloff }
}
// ANCHOR_END: arriving

// ANCHOR: smooth
/// The mean of the corners' normals: 0/0 where they cancel.
pub fn smooth_normal(normals: [Vec3; 3], weights: Vec3) -> Vec3 {
    let [a, b, c] = normals;
    (weights.x * a + weights.y * b + weights.z * c).normalize()
}
// ANCHOR_END: smooth

// ANCHOR: seen_normal
/// The shading normal, turned to the eye's side by itself: wrong near the rim of a smooth mesh.
pub fn seen_normal(normal: Vec3, toward_eye: Vec3) -> Vec3 {
    facing(normal, toward_eye)
}
// ANCHOR_END: seen_normal

// ANCHOR: normalization
/// The factor that keeps a highlight's energy, as it is often quoted: an approximation.
pub fn normalization(shininess: f32) -> f32 {
    (shininess + 8.0) / (8.0 * PI)
}
// ANCHOR_END: normalization

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::{Vec2, Vec3};

    use super::Published;
    use crate::light::{Arriving, Light};
    use crate::material::BlinnPhong;
    use crate::models::{Blinn, Model};
    use crate::paint::Paint;

    /// Erratum 9: where the lamp is before the surface, the published line is right; behind it, it
    /// takes light away, and for most exponents it is not a number.
    #[test]
    fn the_published_line_is_right_on_the_lit_side_only() {
        let red = Paint::Plain(Color::new(0.7, 0.2, 0.1));
        let material = BlinnPhong::glossy(red, Color::splat(0.3), 2.5);
        let surface = material.at::<true>(Vec2::ZERO);
        let eye = Vec3::new(0.0, 0.6, 0.8);
        let of = |toward: Vec3| {
            let arriving = Arriving { toward, distance: 9.0, color: Color::ONE };
            [
                Published::returned(&surface, Vec3::Y, eye, &arriving),
                Blinn::returned(&surface, Vec3::Y, eye, &arriving),
            ]
        };
        let [published, ours] = of(Vec3::new(0.48, 0.8, 0.36));
        assert_eq!(published, ours);
        let [published, ours] = of(Vec3::new(0.8, -0.6, 0.0));
        assert!(published.x < 0.0 && ours == Color::ZERO);
        let [published, ours] = of(Vec3::new(0.48, -0.8, 0.36));
        assert!(published.is_nan() && ours == Color::ZERO);
    }

    /// Erratum 10: a light far enough away and one infinitely far away are the same, but the
    /// formula asks for neither: near by it takes the direction from the point to the lamp.
    #[test]
    fn the_formula_needs_no_lamp_at_infinity() {
        let direction = Vec3::new(2.0, 3.0, 6.0) / 7.0;
        let sun = Light::far(direction, Color::ONE).expect("a direction");
        let error = |distance: f32| {
            let lamp = Light::steady(distance * direction, Color::ONE);
            let there = Vec3::new(1.0, 0.0, -2.0);
            let toward = |light: &Light| light.at(there).expect("it is elsewhere").toward;
            (toward(&lamp) - toward(&sun)).length()
        };
        assert!(error(1e7) < 1e-6 && error(70.0) > 0.02 && error(7.0) > 0.2);
    }
}
