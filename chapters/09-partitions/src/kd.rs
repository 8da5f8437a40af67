//! A k-d tree: space cut in two across an axis, and each part again.
//!
//! Bentley, "Multidimensional Binary Search Trees Used for Associative Searching" (Communications
//! of the ACM 18(9), 1975).

use common::tally::{Off, Tally};
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::accelerator::{Accelerator, Statistics};
use crate::leaf::{Question, Stored};
use crate::median::median;
use crate::plane_tree::{Node, PlaneTree};
use crate::plant::{Cell, Plane, plant};
use crate::surface_area::cheapest;
use crate::wide::WideRay;

// ANCHOR: kd
/// A k-d tree: by the medians of triangles, or by surface area.
#[derive(Clone, Debug)]
pub struct KdTree(PlaneTree<3>);

/// Where a k-d tree's planes are put.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Split {
    /// Half of the triangles on each side, across the cell's longest side.
    Median,
    /// Where tests are expected to be fewest, by surface area.
    #[default]
    Sah,
}

impl KdTree {
    /// The tree with its planes put where `split` says.
    pub fn with_split(triangles: &[[Vec3; 3]], split: Split) -> Self {
        let choose = match split {
            Split::Median => by_median,
            Split::Sah => cheapest,
        };
        Self(plant(triangles, Vec3::AXES, |_| Vec3::ZERO, choose))
    }

    /// Puts `question` to the leaves along a ray of any width.
    pub(crate) fn walk_wide(&self, ray: &WideRay, question: &mut impl Question) {
        self.0.walk(ray, question, &mut Off);
    }

    /// The node at this place; the root's is 0.
    pub(crate) fn node(&self, place: usize) -> Node {
        self.0.nodes[place]
    }

    /// The triangles of a leaf.
    pub(crate) fn leaf(&self, first: u32, count: u32) -> &[Stored] {
        &self.0.stored[first as usize..(first + count) as usize]
    }
}
// ANCHOR_END: kd

// ANCHOR: median
/// The most triangles that are left together where planes are put by medians.
pub const FEW: usize = 8;

/// The median across the cell's longest side.
fn by_median(cell: &Cell<3>) -> Option<Plane> {
    if cell.members.len() <= FEW {
        return None;
    }
    let length = |direction: &usize| cell.extent[*direction].high - cell.extent[*direction].low;
    let direction = (0..3).max_by(|one, other| length(one).total_cmp(&length(other)))?;
    Some(Plane { direction, place: median(cell, direction) })
}
// ANCHOR_END: median

impl Accelerator for KdTree {
    fn build(triangles: Vec<[Vec3; 3]>) -> Self {
        Self::with_split(&triangles, Split::default())
    }

    fn walk<Q: Question, T: Tally>(&self, ray: &Ray, question: &mut Q, tally: &mut T) {
        self.0.walk(&self.0.wide(ray), question, tally);
    }

    fn statistics(&self) -> Statistics {
        self.0.statistics()
    }
}

#[cfg(test)]
mod tests {
    use triangles::bumpy;

    use super::{KdTree, Split};
    use crate::plane_tree::Node;

    #[test]
    fn the_first_median_halves_the_triangles_across_the_longest_side() {
        let mut triangles = bumpy::sphere(1000).all_corners();
        for corner in triangles.iter_mut().flatten() {
            corner.y *= 3.0;
        }
        let tree = KdTree::with_split(&triangles, Split::Median);
        let Node::Inner { direction, plane, .. } = tree.node(0) else { panic!("a leaf") };
        let middle = |corners: &[glam::Vec3; 3]| {
            let [a, b, c] = corners.map(|it| it.y);
            (a.min(b).min(c) + a.max(b).max(c)) / 2.0
        };
        let below = triangles.iter().filter(|it| middle(it) < plane).count();
        assert_eq!(direction, 1);
        assert!((495..=505).contains(&below), "{below}");
    }

    #[test]
    fn by_surface_area_a_cluster_is_cut_off_from_empty_space() {
        let mut triangles = bumpy::sphere(400).all_corners();
        let far = triangles.iter().map(|it| it.map(|corner| corner + 50.0 * glam::Vec3::X));
        let far: Vec<_> = far.take(40).collect();
        triangles.extend(far);
        let tree = KdTree::with_split(&triangles, Split::Sah);
        let Node::Inner { direction, plane, .. } = tree.node(0) else { panic!("a leaf") };
        // The sphere ends near 1.3, the others begin beyond 48.
        assert!(direction == 0 && 1.0 < plane && plane < 49.0, "{direction} {plane}");
    }
}
