//! What scenes are made of: shapes with materials, some of which glow.

use common::film::Color;
use glam::Vec3;
use ray_casting::sphere::Sphere;

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

    /// What it sends out on the side of a direction whose height over the surface is `z`.
    #[inline]
    pub fn towards(&self, z: f32) -> Color {
        if z > 0.0 || self.both_sides { self.radiance } else { Color::ZERO }
    }
}
