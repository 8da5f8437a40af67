//! A surface that reflects.

use blinn_phong::material::BlinnPhong;
use common::film::Color;

// ANCHOR: material
/// A surface that returns lamps' light as in chapter 4, and mirrors what is before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirrored {
    /// What it returns of lamps.
    pub surface: BlinnPhong,
    /// What it returns of the radiance that its mirror ray brings, each part in [0, 1].
    pub mirror: Color,
}
// ANCHOR_END: material

impl Mirrored {
    /// A surface without a mirror.
    pub fn dull(surface: BlinnPhong) -> Self {
        Self { surface, mirror: Color::ZERO }
    }

    /// Whether there is anything to mirror.
    pub fn reflects(&self) -> bool {
        self.mirror != Color::ZERO
    }
}
