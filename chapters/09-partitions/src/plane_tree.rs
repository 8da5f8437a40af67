//! A tree of planes: each cuts what is left of space in two, and a leaf holds a few triangles.
//!
//! A k-d tree has planes across the three axes, a BSP tree planes in other directions too. All else
//! is the same.

use boxes::aabb::Aabb;
use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::accelerator::{NODE_VISITS, Statistics};
use crate::leaf::{Question, Stored};
use crate::wide::{Interval, Track, WideRay};

// ANCHOR: node
/// A node of the tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    /// Space cut in two. What is below the plane follows at the next place.
    Inner {
        /// The number of the direction the plane stands across.
        direction: u8,
        /// How far along that direction.
        plane: f32,
        /// The place of what is above the plane.
        above: u32,
    },
    /// Space that isn't cut any more.
    Leaf {
        /// The place of its first triangle.
        first: u32,
        /// How many triangles it has.
        count: u32,
    },
}
// ANCHOR_END: node

/// The most steps from the root to a leaf.
pub const DEEPEST: usize = 48;

/// A tree whose planes stand across `N` directions.
#[derive(Clone, Debug)]
pub struct PlaneTree<const N: usize> {
    /// The directions: three small whole numbers each.
    pub(crate) directions: [Vec3; N],
    /// From where planes are measured along them.
    pub(crate) base: Vec3,
    pub(crate) bounds: Aabb,
    pub(crate) nodes: Vec<Node>,
    pub(crate) stored: Vec<Stored>,
    pub(crate) triangles: usize,
    pub(crate) left_out: usize,
    pub(crate) depth: usize,
}

/// A node still to be visited, and the part of the ray that is in it.
#[derive(Clone, Copy)]
struct Visit {
    node: u32,
    part: Interval,
}

impl<const N: usize> PlaneTree<N> {
    // ANCHOR: walk
    /// Puts `question` to the leaves along the ray, the near side of each plane first.
    ///
    /// The part of the ray that is near to one side and the part that is near to the other overlap
    /// by the ray's width. So a node is left out only if it begins beyond the question's limit.
    pub(crate) fn walk<Q: Question, T: Tally>(
        &self,
        ray: &WideRay,
        question: &mut Q,
        tally: &mut T,
    ) {
        let part = ray.within(&self.bounds, question.limit());
        if part.is_empty() {
            return;
        }
        let tracks = self.directions.map(|direction| ray.track_along(direction, self.base));
        let mut waiting = [Visit { node: 0, part }; DEEPEST + 1];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let Visit { mut node, mut part } = waiting[count];
            if part.from > ray.reach(question.limit()) {
                continue;
            }
            loop {
                tally.count(NODE_VISITS, 1);
                match self.nodes[node as usize] {
                    Node::Leaf { first, count } => {
                        let leaf = first as usize..(first + count) as usize;
                        question.ask_all(&self.stored[leaf], tally);
                        break;
                    }
                    Node::Inner { direction, plane, above } => {
                        let [near, far] =
                            sides(&tracks[direction as usize], plane, part, [node + 1, above]);
                        match (near.part.is_empty(), far.part.is_empty()) {
                            (false, true) => Visit { node, part } = near,
                            (true, false) => Visit { node, part } = far,
                            (true, true) => break,
                            (false, false) => {
                                waiting[count] = far;
                                count += 1;
                                Visit { node, part } = near;
                            }
                        }
                    }
                }
            }
            if question.answered() {
                return;
            }
        }
    }
    // ANCHOR_END: walk

    /// The ray, as wide as it has to be for this tree.
    pub(crate) fn wide(&self, ray: &Ray) -> WideRay {
        WideRay::new(ray, &self.bounds)
    }

    pub(crate) fn statistics(&self) -> Statistics {
        Statistics {
            triangles: self.triangles,
            left_out: self.left_out,
            references: self.stored.len(),
            nodes: self.nodes.len(),
            depth: self.depth,
            bytes: size_of_val(&self.nodes[..]) + size_of_val(&self.stored[..]),
        }
    }
}

// ANCHOR: sides
/// The two sides of a plane with the parts of the ray in them, the one that it comes to first first.
#[inline]
fn sides(track: &Track, plane: f32, part: Interval, [below, above]: [u32; 2]) -> [Visit; 2] {
    let below = Visit { node: below, part: part.below(track, plane) };
    let above = Visit { node: above, part: part.above(track, plane) };
    if track.ascends() { [below, above] } else { [above, below] }
}
// ANCHOR_END: sides
