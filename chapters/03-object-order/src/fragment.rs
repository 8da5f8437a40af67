//! What a sample sees: the answer that both orders give.

use common::film::Color;
use common::render::Pixel;
use glam::Vec3;

use crate::fixed::Fixed;

/// The nearest surface at a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment {
    /// The triangle's number in the mesh.
    pub triangle: u32,
    /// Its depth along the line of sight, in units of the scene.
    pub depth: f32,
    /// The shares of its three corners: none negative, sum 1.
    pub barycentric: Vec3,
}

/// What a picture makes of a sample: of its pixel, its place in it and what it sees, with a tally.
pub type Shade<'a, T> = dyn Fn(Pixel, Fixed, Option<Fragment>, &mut T) -> Color + Sync + 'a;
