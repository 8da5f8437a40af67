//! Which structure, and how a tree is built and walked, as a reader names it.

use partitions::choice::AccelChoice as Partition;
use ray_casting::shape::Shape;
use triangles::mesh::Mesh;

use crate::seam::accelerated;

/// A structure to find triangles with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum AccelChoice {
    /// None: every triangle is asked
    Brute,
    /// Equal boxes
    Grid,
    /// Boxes cut in eight, again and again
    Octree,
    /// Boxes cut in two across an axis
    Kd,
    /// Space cut in two by slanted planes
    Bsp,
    /// Boxes around boxes around triangles
    #[default]
    Bvh,
}

impl AccelChoice {
    /// What makes a mesh a shape that is found this way.
    pub fn shape(self) -> fn(Mesh) -> Box<dyn Shape> {
        match self {
            Self::Brute => Partition::Brute.shape(),
            Self::Grid => Partition::Grid.shape(),
            Self::Octree => Partition::Octree.shape(),
            Self::Kd => Partition::Kd.shape(),
            Self::Bsp => Partition::Bsp.shape(),
            Self::Bvh => accelerated,
        }
    }
}

/// How a ray goes through a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Traversal {
    /// Into both children, whatever was found: the report's way
    Both,
    /// Into the nearer child first, and past what lies behind the nearest hit so far
    #[default]
    Ordered,
}

/// What the picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum ViewChoice {
    /// The scene under its lamps, with shadows
    #[default]
    Lit,
    /// Directions of the surface as colours
    Normals,
    /// Distances as greys
    Depth,
    /// Triangle tests and nodes of each ray, from black for none to white for 400
    Work,
    /// The tree's boxes where a plane cuts them
    Cut,
}
