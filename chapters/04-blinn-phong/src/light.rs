//! Lamps, and what arrives of them.

use common::film::Color;
use glam::Vec3;
use ray_casting::direction::unit;

// ANCHOR: light
/// A lamp without extent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// At a place, and sending alike in all directions.
    Point {
        /// Where it is.
        position: Vec3,
        /// What arrives at distance d is `color / (falloff[0] + falloff[1] d + falloff[2] d²)`.
        color: Color,
        /// The constant, linear and quadratic part; `[1, 0, 0]` does not fall off, as in the report.
        falloff: [f32; 3],
    },
    /// So far away that all its light runs one way.
    Directional {
        /// Towards the lamp, of length 1.
        toward: Vec3,
        /// What arrives.
        color: Color,
    },
}
// ANCHOR_END: light

/// What arrives of a lamp at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arriving {
    /// The direction to the lamp, of length 1.
    pub toward: Vec3,
    /// How far away it is; infinite for a directional one.
    pub distance: f32,
    /// How much of red, green and blue arrives, on a surface that faces the lamp.
    pub color: Color,
}

impl Light {
    // ANCHOR: at
    /// What arrives at `point`. None where the lamp itself is: light from no direction.
    pub fn at(&self, point: Vec3) -> Option<Arriving> {
        match *self {
            Self::Directional { toward, color } => {
                Some(Arriving { toward, distance: f32::INFINITY, color })
            }
            Self::Point { position, color, falloff: [constant, linear, quadratic] } => {
                let toward = unit(position - point)?;
                let distance = (position - point).dot(toward);
                let falloff = constant + distance * (linear + distance * quadratic);
                Some(Arriving { toward, distance, color: color / falloff })
            }
        }
    }
    // ANCHOR_END: at
}
