//! Models of what a surface returns: Lambert's, Phong's, Blinn's, and Blinn's with its energy kept.

use std::f32::consts::PI;

use common::film::Color;
use glam::Vec3;

use crate::energy::normalization;
use crate::light::Arriving;
use crate::material::Surface;
use crate::power::power_of_cosine;
use crate::shading;

// ANCHOR: model
/// A model of highlights. All share Lambert's diffuse part.
pub trait Model: Send + Sync {
    /// How strong the highlight is, on the side of the surface that the lamp lights.
    ///
    /// All directions have length 1 and lead away from the surface; `shininess` is n, 0 or more.
    fn highlight(normal: Vec3, toward_eye: Vec3, toward_light: Vec3, shininess: f32) -> f32;
    // ANCHOR_END: model

    /// The light of one lamp that a surface returns `toward_eye`, for a normal on the eye's side.
    fn returned(surface: &Surface, normal: Vec3, toward_eye: Vec3, arriving: &Arriving) -> Color {
        shading::returned::<Self>(surface, normal, toward_eye, arriving)
    }
}

/// No highlight at all: Lambert, "Photometria" (1760).
pub struct Lambert;

/// A highlight around the direction of the mirror: Phong, "Illumination for computer generated
/// pictures" (1975).
pub struct Phong;

/// A highlight around the normal, measured by the half vector: Blinn, "Models of light reflection
/// for computer synthesized pictures" (1977).
pub struct Blinn;

/// Blinn's highlight, scaled so that of a lamp's light a surface with k_s = 1 returns all and no
/// more: one that is narrow is bright.
pub struct Normalized;

impl Model for Lambert {
    fn highlight(_normal: Vec3, _toward_eye: Vec3, _toward_light: Vec3, _shininess: f32) -> f32 {
        0.0
    }
}

// ANCHOR: phong
impl Model for Phong {
    fn highlight(normal: Vec3, toward_eye: Vec3, toward_light: Vec3, shininess: f32) -> f32 {
        let mirrored = 2.0 * normal.dot(toward_light) * normal - toward_light;
        lobe(mirrored.dot(toward_eye), shininess)
    }
}
// ANCHOR_END: phong

// ANCHOR: blinn
impl Model for Blinn {
    fn highlight(normal: Vec3, toward_eye: Vec3, toward_light: Vec3, shininess: f32) -> f32 {
        lobe(normal.dot(half_vector(toward_eye, toward_light)), shininess)
    }
}

/// The direction halfway between two; zero where they are opposite and nothing is halfway.
pub fn half_vector(toward_eye: Vec3, toward_light: Vec3) -> Vec3 {
    (toward_eye + toward_light).normalize_or_zero()
}
// ANCHOR_END: blinn

// ANCHOR: normalized
impl Model for Normalized {
    fn highlight(normal: Vec3, toward_eye: Vec3, toward_light: Vec3, shininess: f32) -> f32 {
        let cosine = normal.dot(toward_light).max(0.0);
        let strength = Blinn::highlight(normal, toward_eye, toward_light, shininess);
        PI * normalization(shininess) * strength * cosine
    }
}
// ANCHOR_END: normalized

// ANCHOR: lobe
/// cosⁿ, from 0 to 1 whatever the cosine; 0 for n = 0, where the lobe would be all around.
///
/// Rounding carries a cosine above 1, where a large n makes much of it, and below 0, where a
/// fractional n makes it NaN (hard case BP-02).
#[inline]
pub fn lobe(cosine: f32, shininess: f32) -> f32 {
    if !(cosine > 0.0 && shininess > 0.0) {
        return 0.0;
    }
    power_of_cosine(cosine.min(1.0), shininess)
}
// ANCHOR_END: lobe

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::{DVec3, Vec3};

    use super::{Blinn, Lambert, Model, Normalized, Phong, half_vector, lobe};

    fn direction(stream: &mut Stream) -> Vec3 {
        let mut component = || stream.between(-1.0, 1.0);
        Vec3::new(component(), component(), component()).normalize()
    }

    #[test]
    fn all_are_full_in_the_direction_of_the_mirror() {
        let (eye, light) = (Vec3::new(0.6, 0.8, 0.0), Vec3::new(-0.6, 0.8, 0.0));
        assert_eq!(Lambert::highlight(Vec3::Y, eye, light, 3.0), 0.0);
        for highlight in [Phong::highlight, Blinn::highlight] {
            assert!((highlight(Vec3::Y, eye, light, 3.0) - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn by_hand() {
        // The lamp is straight above and the eye 60 degrees aside: the mirror is 60 degrees from
        // the eye and the half vector 30 degrees from the normal.
        let eye = Vec3::new(0.75f32.sqrt(), 0.5, 0.0);
        let phong = Phong::highlight(Vec3::Y, eye, Vec3::Y, 3.0);
        let blinn = Blinn::highlight(Vec3::Y, eye, Vec3::Y, 3.0);
        assert!((phong - 0.125).abs() < 1e-6, "(1/2)³: {phong}");
        assert!((blinn - 0.649_519).abs() < 1e-6, "(√3/2)³: {blinn}");
    }

    /// In the plane of mirror and lamp Phong's angle is twice Blinn's.
    #[test]
    fn in_the_plane_of_incidence_one_angle_is_twice_the_other() {
        for trial in 0..10_000 {
            let mut stream = Stream::of_trial(41, trial);
            let (light, eye) = (stream.between(-1.0, 1.0), stream.between(-1.0, 1.0));
            let at = |tangent: f32| Vec3::new(tangent, 1.0, 0.0).normalize();
            let mirrored = Vec3::new(-at(light).x, at(light).y, 0.0).as_dvec3();
            let half = half_vector(at(eye), at(light)).as_dvec3();
            let (phong, blinn) = (mirrored.dot(at(eye).as_dvec3()), half.dot(DVec3::Y));
            // cos 2a = 2 cos² a - 1
            assert!((phong - (2.0 * blinn * blinn - 1.0)).abs() < 1e-6, "{light} {eye}");
        }
    }

    #[test]
    fn eye_and_lamp_may_change_places_to_the_bit() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(42, trial);
            let [normal, eye, light] = [(); 3].map(|()| direction(&mut stream));
            let there = Blinn::highlight(normal, eye, light, 30.0);
            assert_eq!(there.to_bits(), Blinn::highlight(normal, light, eye, 30.0).to_bits());
        }
    }

    #[test]
    fn narrow_is_bright_once_energy_is_kept() {
        let strength = |shininess| Normalized::highlight(Vec3::Y, Vec3::Y, Vec3::Y, shininess);
        // (n + 2)(n + 4) / 8(n + 2^(-n/2)) by hand: 24 / (8 · 2.5) and 120 / (8 · 8.0625).
        assert!((strength(2.0) - 1.2).abs() < 1e-6);
        assert!((strength(8.0) - 120.0 / 64.5).abs() < 1e-6);
        assert_eq!(strength(0.0), 0.0);
    }

    #[test]
    fn a_lobe_has_a_value_everywhere() {
        for cosine in [f32::NAN, -1.5, -0.0, 0.0, 1e-45, 0.5, 1.0, 1.000_000_4, f32::INFINITY] {
            for shininess in [0.0, 1e-9, 1.0, 2.5, 1e5, 1e38] {
                let strength = lobe(cosine, shininess);
                assert!((0.0..=1.0).contains(&strength), "{cosine} {shininess}: {strength}");
            }
        }
        assert_eq!((lobe(1.000_000_4, 1e5), lobe(0.7, 0.0)), (1.0, 0.0));
        assert_eq!(half_vector(Vec3::Z, Vec3::NEG_Z), Vec3::ZERO);
    }
}
