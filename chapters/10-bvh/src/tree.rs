//! The tree: an index over boxes that never sees what is in them.

use boxes::aabb::Aabb;

use crate::build::DEPTH;
use crate::node::Node;

// ANCHOR: bvh
/// A bounding volume hierarchy: boxes of boxes, and at the bottom numbers of things.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bvh {
    /// The root first, then below each other, children in pairs; none for a tree of nothing.
    pub nodes: Vec<Node>,
    /// The numbers of the things, leaf after leaf.
    pub order: Vec<u32>,
}
// ANCHOR_END: bvh

impl Bvh {
    /// The box around everything.
    pub fn bounds(&self) -> Aabb {
        self.nodes.first().map_or(Aabb::EMPTY, |root| root.bounds)
    }

    /// How many steps each node is below the root.
    pub fn levels(&self) -> Vec<u32> {
        let mut levels = vec![0; self.nodes.len()];
        // A node's children come after it, so its own level is known by then.
        for (place, node) in self.nodes.iter().enumerate().filter(|(_, node)| !node.is_leaf()) {
            for child in node.children() {
                levels[child] = levels[place] + 1;
            }
        }
        levels
    }

    /// How many steps it is from the root to the deepest leaf.
    pub fn depth(&self) -> u32 {
        self.levels().into_iter().max().unwrap_or(0)
    }

    /// What is wrong with it as a tree over `boxes`, none of which is empty or infinite; None when
    /// nothing is.
    pub fn flaw(&self, boxes: &[Aabb]) -> Option<&'static str> {
        let mut found = vec![0; boxes.len()];
        for node in &self.nodes {
            let inside = |inner: &Aabb| node.bounds.union(*inner) == node.bounds;
            if node.is_leaf() {
                for &item in &self.order[node.items()] {
                    found[item as usize] += 1;
                    if !inside(&boxes[item as usize]) {
                        return Some("a thing reaches out of its leaf");
                    }
                }
            } else if !node.children().iter().all(|&child| inside(&self.nodes[child].bounds)) {
                return Some("a child reaches out of its parent");
            }
        }
        if found.iter().any(|&times| times != 1) {
            return Some("a thing is missing, or there twice");
        }
        (self.depth() > DEPTH).then_some("it is deeper than the stack is high")
    }
}
