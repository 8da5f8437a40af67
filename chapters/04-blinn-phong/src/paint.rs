//! Colours that vary over a surface.

use common::film::Color;
use glam::Vec2;

/// A colour for each place of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Paint {
    /// The same everywhere.
    Plain(Color),
    /// A checkerboard.
    Checker {
        /// Squares from one side of the surface to the other.
        squares: f32,
        /// The colour of the square in the corner where u and v are 0, and that of its neighbours.
        colors: [Color; 2],
    },
}

impl Paint {
    // ANCHOR: at
    /// The colour at the place `uv`, both coordinates in [0, 1].
    pub fn at(&self, uv: Vec2) -> Color {
        match *self {
            Self::Plain(color) => color,
            Self::Checker { squares, colors } => {
                let square = (uv * squares).floor();
                colors[((square.x + square.y) as i64).rem_euclid(2) as usize]
            }
        }
    }
    // ANCHOR_END: at
}
