//! Which structure, as a reader names it.

use ray_casting::shape::Shape;
use triangles::mesh::Mesh;

use crate::bsp::BspTree;
use crate::grid::Grid;
use crate::indexed::Indexed;
use crate::kd::KdTree;
use crate::octree::Octree;
use crate::scan::Scan;

/// A structure to find triangles with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum AccelChoice {
    /// None: every triangle is asked
    Brute,
    /// Equal boxes
    #[default]
    Grid,
    /// Boxes cut in eight, again and again
    Octree,
    /// Boxes cut in two across an axis
    Kd,
    /// Space cut in two by slanted planes
    Bsp,
}

impl AccelChoice {
    /// What makes a mesh a shape that is found this way.
    pub fn shape(self) -> fn(Mesh) -> Box<dyn Shape> {
        match self {
            Self::Brute => Indexed::<Scan>::shape,
            Self::Grid => Indexed::<Grid>::shape,
            Self::Octree => Indexed::<Octree>::shape,
            Self::Kd => Indexed::<KdTree>::shape,
            Self::Bsp => Indexed::<BspTree>::shape,
        }
    }
}
