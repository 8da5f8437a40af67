//! What scenes are made of: shapes with materials, some of which glow.

use common::film::Color;
use glam::Vec3;
use ray_casting::sphere::Sphere;

use crate::bsdf::MaterialError;

// ANCHOR: part
/// A thing in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Part<M> {
    /// Where it is.
    pub form: Form,
    /// What it is made of.
    pub material: M,
    /// The light it sends out by itself.
    pub emission: Emission,
}

/// A shape that paths can meet and lights can have.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Triangles, each by its corners, counter-clockwise seen from outside.
    Triangles(Vec<[Vec3; 3]>),
    /// A ball.
    Ball(Sphere),
}

/// The light a surface sends out by itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Emission {
    /// The radiance, the same in all directions.
    pub radiance: Color,
    /// Whether the inner side glows as well as the outer one.
    pub both_sides: bool,
}
// ANCHOR_END: part

impl<M> Part<M> {
    /// A thing that doesn't glow.
    pub fn dark(form: Form, material: M) -> Self {
        Self { form, material, emission: Emission::default() }
    }

    /// A thing whose outer side sends out this radiance.
    pub fn glowing(form: Form, material: M, radiance: Color) -> Self {
        Self { form, material, emission: Emission { radiance, both_sides: false } }
    }

    /// The same thing of another material.
    pub fn map<N>(self, material: impl FnOnce(M) -> N) -> Part<N> {
        Part { form: self.form, material: material(self.material), emission: self.emission }
    }
}

impl Form {
    /// A flat four-sided face as two triangles; its corners run counter-clockwise seen from outside.
    pub fn quad([a, b, c, d]: [Vec3; 4]) -> Self {
        Self::Triangles(vec![[a, b, c], [a, c, d]])
    }

    /// A ball.
    pub fn ball(center: Vec3, radius: f32) -> Self {
        Self::Ball(Sphere { center, radius })
    }
}

impl Emission {
    /// Whether there is any.
    #[inline]
    pub fn glows(&self) -> bool {
        self.radiance != Color::ZERO
    }

    /// # Errors
    /// Radiance that is not finite or below 0.
    pub fn check(&self) -> Result<(), MaterialError> {
        if is_light(self.radiance) { Ok(()) } else { Err(MaterialError::Emission) }
    }

    /// What it sends out on the side of a direction whose height over the surface is `z`.
    #[inline]
    pub fn towards(&self, z: f32) -> Color {
        if z > 0.0 || self.both_sides { self.radiance } else { Color::ZERO }
    }
}

/// Whether it is an amount of light.
pub(crate) fn is_light(radiance: Color) -> bool {
    radiance.to_array().iter().all(|part| part.is_finite() && *part >= 0.0)
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::Vec3;

    use super::{Emission, Form, Part};

    #[test]
    fn one_side_glows_or_both() {
        let one = Emission { radiance: Color::new(1.0, 2.0, 3.0), both_sides: false };
        assert_eq!(one.towards(0.1), one.radiance);
        assert_eq!([one.towards(-0.1), one.towards(0.0)], [Color::ZERO; 2]);
        assert_eq!(Emission { both_sides: true, ..one }.towards(-0.1), one.radiance);
        assert!(one.glows() && !Emission::default().glows());
    }

    #[test]
    fn light_is_a_finite_amount() {
        let check =
            |red| Emission { radiance: Color::new(red, 1.0, 0.0), both_sides: true }.check();
        assert!(check(0.0).is_ok() && check(1e30).is_ok());
        assert!([f32::NAN, f32::INFINITY, -0.5].iter().all(|&red| check(red).is_err()));
    }

    #[test]
    fn a_quad_is_two_triangles_that_face_one_way() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 3.0], [0.0, 3.0]];
        let form = Form::quad(corners.map(|[x, y]| Vec3::new(x, y, 5.0)));
        let Form::Triangles(triangles) = &form else { panic!("triangles") };
        for [a, b, c] in triangles {
            assert_eq!((*b - *a).cross(*c - *a), 6.0 * Vec3::Z);
        }
        let part = Part::dark(form.clone(), 3).map(|material| material + 1);
        assert_eq!((part.form, part.material), (form, 4));
    }
}
