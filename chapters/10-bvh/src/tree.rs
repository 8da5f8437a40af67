//! The tree: an index over boxes that never sees what is in them.

use boxes::aabb::Aabb;

use crate::node::Node;

// ANCHOR: bvh
/// A bounding volume hierarchy.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bvh {
    /// The root first, then below each other, children in pairs; none for a tree of nothing.
    pub nodes: Vec<Node>,
    /// The items' numbers, leaf after leaf.
    pub order: Vec<u32>,
}
// ANCHOR_END: bvh

impl Bvh {
    /// The box around everything.
    pub fn bounds(&self) -> Option<Aabb> {
        self.nodes.first().map(|root| root.bounds)
    }

    /// How many steps it is from the root to the deepest leaf.
    pub fn depth(&self) -> u32 {
        let mut levels = vec![0; self.nodes.len()];
        for (index, node) in self.nodes.iter().enumerate().filter(|(_, node)| !node.is_leaf()) {
            for child in node.children() {
                levels[child] = levels[index] + 1;
            }
        }
        levels.into_iter().max().unwrap_or(0)
    }
}
