//! The shading model: what reaches the eye of the light that reaches a surface.

use common::film::Color;
use glam::Vec3;
use ray_casting::shape::Hit;

use crate::light::Arriving;
use crate::material::{BlinnPhong, Surface};
use crate::models::{Blinn, Model};

/// What a surface point sends `toward_eye` of one lamp's light: the last two terms of equation 2-1
/// of the report, with the clamps that it leaves out.
pub fn lit(material: &BlinnPhong, hit: &Hit, toward_eye: Vec3, arriving: &Arriving) -> Color {
    let normal = seen_normal(hit, toward_eye);
    Blinn::returned(&material.at::<true>(hit.uv), normal, toward_eye, arriving)
}

// ANCHOR: returned
/// The light of one lamp that a surface returns `toward_eye`, for a normal on the eye's side.
#[inline]
pub fn returned<M: Model + ?Sized>(
    surface: &Surface,
    normal: Vec3,
    toward_eye: Vec3,
    arriving: &Arriving,
) -> Color {
    let cosine = normal.dot(arriving.toward);
    // The lamp is behind the surface.
    if !(cosine > 0.0) {
        return Color::ZERO;
    }
    // A surface without a highlight doesn't pay for one.
    let strength = match surface.shininess > 0.0 {
        true => M::highlight(normal, toward_eye, arriving.toward, surface.shininess),
        false => 0.0,
    };
    arriving.color * (cosine * surface.diffuse + strength * surface.specular)
}
// ANCHOR_END: returned

// ANCHOR: seen_normal
/// The normal to shade with, on the side of the surface that is seen.
///
/// Which side that is, the surface's own normal says. The interpolated one of a smooth mesh may
/// point away from the eye near the rim, and turning it around would light the rim from behind.
#[inline]
pub fn seen_normal(hit: &Hit, toward_eye: Vec3) -> Vec3 {
    facing(hit.normal, facing(hit.geometric, toward_eye))
}

/// The normal, turned to the side that `toward` is on.
#[inline]
pub fn facing(normal: Vec3, toward: Vec3) -> Vec3 {
    if normal.dot(toward) < 0.0 { -normal } else { normal }
}
// ANCHOR_END: seen_normal

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::sampler::Stream;
    use glam::{DVec3, Vec2, Vec3};
    use ray_casting::shape::Hit;

    use super::{facing, lit, returned, seen_normal};
    use crate::light::Arriving;
    use crate::material::BlinnPhong;
    use crate::models::{Blinn, Lambert, Phong};
    use crate::paint::Paint;

    fn hit(geometric: Vec3, normal: Vec3) -> Hit {
        Hit { t: 1.0, point: Vec3::ZERO, error: Vec3::ZERO, geometric, normal, uv: Vec2::ZERO }
    }

    fn material() -> BlinnPhong {
        BlinnPhong::glossy(Paint::Plain(Color::new(0.6, 0.3, 0.1)), Color::new(0.2, 0.4, 0.8), 3.0)
    }

    fn arriving(toward: Vec3) -> Arriving {
        Arriving { toward, distance: 5.0, color: Color::new(2.0, 1.0, 0.5) }
    }

    fn direction(stream: &mut Stream) -> Vec3 {
        let mut component = || stream.between(-1.0, 1.0);
        Vec3::new(component(), component(), component()).normalize()
    }

    #[test]
    fn the_worked_number_of_the_page() {
        // N = (0, 1, 0), the lamp at (0.6, 0.8, 0), the eye at (0, 0.8, 0.6): N · L = 0.8, and the
        // half vector is along (0.6, 1.6, 0.6): (N · H)² = 2.56 / 3.28.
        let (light, eye) = (Vec3::new(0.6, 0.8, 0.0), Vec3::new(0.0, 0.8, 0.6));
        let square: f64 = 2.56 / 3.28;
        let strength = square * square.sqrt();
        let sent = lit(&material(), &hit(Vec3::Y, Vec3::Y), eye, &arriving(light));
        let expected = DVec3::new(2.0, 1.0, 0.5)
            * (0.8 * DVec3::new(0.6, 0.3, 0.1) + strength * DVec3::new(0.2, 0.4, 0.8));
        assert!((sent.as_dvec3() - expected).length() < 1e-6, "{sent} {expected}");
    }

    #[test]
    fn a_lamp_behind_the_surface_gives_nothing() {
        let (eye, light) = (Vec3::new(0.0, 1.0, 0.1).normalize(), Vec3::new(0.3, -0.2, 0.9));
        let sent = lit(&material(), &hit(Vec3::Y, Vec3::Y), eye, &arriving(light.normalize()));
        assert_eq!(sent, Color::ZERO);
    }

    #[test]
    fn a_surface_has_two_sides() {
        let (eye, light) = (Vec3::new(0.0, -0.8, 0.6), Vec3::new(0.6, -0.8, 0.0));
        let [out, back] = [Vec3::Y, Vec3::NEG_Y]
            .map(|normal| lit(&material(), &hit(normal, normal), eye, &arriving(light)));
        assert_eq!(out, back);
        assert!(out.min_element() > 0.0);
    }

    #[test]
    fn the_rim_is_not_lit_from_behind() {
        // The triangle faces the eye; the smooth normal leans away from it by a little.
        let eye = Vec3::Z;
        let (geometric, normal) =
            (Vec3::new(0.8, 0.0, 0.6), Vec3::new(0.99, 0.0, -0.1).normalize());
        assert_eq!(seen_normal(&hit(geometric, normal), eye), normal);
        assert_eq!(facing(normal, eye), -normal, "the naive form");
        // From behind, both are turned.
        assert_eq!(seen_normal(&hit(-geometric, -normal), eye), normal);
        // A file whose normals point inwards.
        assert_eq!(seen_normal(&hit(geometric, -normal), eye), normal);
    }

    #[test]
    fn the_models_differ_in_their_highlights_only() {
        let dull = BlinnPhong::matte(Paint::Plain(Color::new(0.6, 0.3, 0.1)));
        for trial in 0..20_000 {
            let mut stream = Stream::of_trial(43, trial);
            let [normal, eye, light] = [(); 3].map(|()| direction(&mut stream));
            let of = |material: &BlinnPhong| {
                let surface = material.at::<true>(Vec2::ZERO);
                let arriving = arriving(light);
                [
                    returned::<Lambert>(&surface, normal, eye, &arriving),
                    returned::<Phong>(&surface, normal, eye, &arriving),
                    returned::<Blinn>(&surface, normal, eye, &arriving),
                ]
            };
            let [lambert, phong, blinn] = of(&dull);
            assert!(lambert == phong && lambert == blinn);
            let [matte, phong, blinn] = of(&material());
            assert_eq!(matte, lambert);
            assert!(matte.cmple(phong).all() && matte.cmple(blinn).all());
        }
    }
}
