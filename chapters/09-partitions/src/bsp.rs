//! A BSP tree: space cut in two by planes that may stand slanted.
//!
//! Fuchs, Kedem and Naylor, "On Visible Surface Generation by a Priori Tree Structures" (SIGGRAPH
//! 1980) cut along the triangles themselves. Planes in a few directions only: Kammaje and Mora, "A
//! Study of Restricted BSP Trees for Ray Tracing" (Symposium on Interactive Ray Tracing 2007).

use boxes::aabb::Aabb;
use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::accelerator::{Accelerator, Statistics};
use crate::kd::FEW;
use crate::leaf::Question;
use crate::median::{counts, median};
use crate::plane_tree::PlaneTree;
use crate::plant::{Cell, Plane, plant};

// ANCHOR: directions
/// Across which planes stand: the edges, face diagonals and space diagonals of a cube.
pub const DIRECTIONS: [Vec3; 13] = [
    Vec3::new(1.0, 0.0, 0.0),
    Vec3::new(0.0, 1.0, 0.0),
    Vec3::new(0.0, 0.0, 1.0),
    Vec3::new(1.0, 1.0, 0.0),
    Vec3::new(1.0, -1.0, 0.0),
    Vec3::new(1.0, 0.0, 1.0),
    Vec3::new(1.0, 0.0, -1.0),
    Vec3::new(0.0, 1.0, 1.0),
    Vec3::new(0.0, 1.0, -1.0),
    Vec3::new(1.0, 1.0, 1.0),
    Vec3::new(1.0, 1.0, -1.0),
    Vec3::new(1.0, -1.0, 1.0),
    Vec3::new(1.0, -1.0, -1.0),
];
// ANCHOR_END: directions

/// A BSP tree.
#[derive(Clone, Debug)]
pub struct BspTree(PlaneTree<13>);

// ANCHOR: fewest_cut
/// Of the medians in all directions the one whose fuller side has the fewest triangles: it cuts few
/// of them, and has about as many above as below. The first of equals.
fn fewest_cut(cell: &Cell<13>) -> Option<Plane> {
    if cell.members.len() <= FEW {
        return None;
    }
    let planes =
        (0..DIRECTIONS.len()).map(|direction| Plane { direction, place: median(cell, direction) });
    planes.min_by_key(|plane| {
        let [below, above] = counts(cell.spans_along(plane.direction), plane.place);
        (below.max(above), below.min(above))
    })
}
// ANCHOR_END: fewest_cut

impl Accelerator for BspTree {
    fn build(triangles: Vec<[Vec3; 3]>) -> Self {
        // Measured from the middle: far from the origin a product would lose what matters.
        Self(plant(&triangles, DIRECTIONS, Aabb::center, fewest_cut))
    }

    fn walk<Q: Question, T: Tally>(&self, ray: &Ray, question: &mut Q, tally: &mut T) {
        self.0.walk(&self.0.wide(ray), question, tally);
    }

    fn statistics(&self) -> Statistics {
        self.0.statistics()
    }
}
