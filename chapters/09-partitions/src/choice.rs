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

#[cfg(test)]
mod tests {
    use clap::ValueEnum;
    use glam::Vec3;
    use ray_casting::ray::Ray;
    use triangles::bumpy;

    use super::AccelChoice;

    #[test]
    fn every_choice_makes_the_same_shape() {
        let mesh = bumpy::sphere(500);
        let ray = Ray::new(Vec3::new(0.3, 2.0, 4.0), Vec3::new(0.1, -2.0, -4.0)).expect("finite");
        let expected = AccelChoice::Brute.shape()(mesh.clone()).hit(&ray, f32::INFINITY);
        assert!(expected.is_some());
        for choice in AccelChoice::value_variants() {
            let shape = choice.shape()(mesh.clone());
            assert_eq!(shape.hit(&ray, f32::INFINITY), expected, "{choice:?}");
            assert!(shape.is_hit(&ray, f32::INFINITY) && !shape.is_hit(&ray, 1.0));
        }
    }
}
