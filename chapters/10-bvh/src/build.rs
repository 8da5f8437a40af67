//! Building: cut the items in two, and each part again.

use boxes::aabb::Aabb;
use triangles::lanes::LANES;

use crate::item::{Item, Span};
use crate::node::Node;
use crate::split::{Limits, Split, cut};
use crate::tree::Bvh;

// ANCHOR: depth
/// The most levels of children below the root.
///
/// A node at level d may hold at most `leaf << (DEPTH - d)` items: then halving them, once a level,
/// is sure to end in leaves of `leaf` items. A cut that would leave more on one side is replaced by
/// the median. So a traversal that puts aside one node a level needs a stack of this size and never
/// more (hard case AC-04).
pub const DEPTH: u32 = 64;
// ANCHOR_END: depth

/// Parts of this many items are worth a task of their own.
const TASK: usize = 4096;

/// How a tree is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// How items are cut in two.
    pub split: Split,
    /// The most items in a leaf, at least 1.
    pub leaf: usize,
    /// How many items are asked for the price of one: a power of two.
    pub together: u32,
}

impl Recipe {
    /// For triangles that are asked four at a time: by surface area, up to four a leaf.
    pub const TRIANGLES: Self = Self { split: Split::Sah, leaf: LANES, together: LANES as u32 };
}

impl Default for Recipe {
    /// By surface area, down to single items.
    fn default() -> Self {
        Self { split: Split::Sah, leaf: 1, together: 1 }
    }
}

/// A part of the items that is to become a subtree.
struct Part<'a> {
    items: &'a mut [Item],
    /// Where in the order the first of them is.
    place: usize,
    /// How many steps below the root.
    level: u32,
}

impl Recipe {
    /// The tree over these boxes. Empty boxes and those that are not finite are left out.
    pub fn build(&self, boxes: impl IntoIterator<Item = Aabb>) -> Bvh {
        let boxes = (0..).zip(boxes);
        let mut items: Vec<Item> =
            boxes.filter_map(|(index, bounds)| Item::new(&bounds, index)).collect();
        let mut nodes = Vec::with_capacity(items.len());
        if !items.is_empty() {
            nodes.push(Node { bounds: Span::EMPTY.aabb(), first: 0, count: 0 });
            let whole = Part { items: &mut items, place: 0, level: 0 };
            nodes[0] = self.grow(whole, &mut nodes);
        }
        Bvh { nodes, order: items.iter().map(Item::index).collect() }
    }

    // ANCHOR: grow
    /// The node for these items; all that is below it is added to `nodes`, first children first.
    fn grow(&self, part: Part, nodes: &mut Vec<Node>) -> Node {
        let Part { items, place, level } = part;
        let (mut bounds, mut centers) = (Span::EMPTY, Span::EMPTY);
        for item in items.iter() {
            bounds.add(item);
            centers.add_point(item.center());
        }
        let middle = self.limits(level).and_then(|limits| cut(items, &bounds, &centers, self.split, limits));
        let Some(middle) = middle else {
            return Node { bounds: bounds.aabb(), first: place as u32, count: items.len() as u32 };
        };
        let (left, right) = items.split_at_mut(middle);
        let left = Part { items: left, place, level: level + 1 };
        let right = Part { items: right, place: place + middle, level: level + 1 };

        let first = nodes.len();
        let inner = Node { bounds: bounds.aabb(), first: first as u32, count: 0 };
        nodes.extend([inner; 2]);
        if left.items.len().min(right.items.len()) < TASK {
            nodes[first] = self.grow(left, nodes);
            nodes[first + 1] = self.grow(right, nodes);
        } else {
            let ((left, below_left), (right, below_right)) =
                both(|| self.grow_apart(left), || self.grow_apart(right));
            nodes[first] = append(nodes, left, below_left);
            nodes[first + 1] = append(nodes, right, below_right);
        }
        inner
    }
    // ANCHOR_END: grow

    /// The node for these items, and a list of all that is below it.
    fn grow_apart(&self, part: Part) -> (Node, Vec<Node>) {
        let mut below = Vec::with_capacity(part.items.len());
        (self.grow(part, &mut below), below)
    }

    /// What a cut of a node at this level may do; None on the lowest, where no more is needed.
    fn limits(&self, level: u32) -> Option<Limits> {
        let (leaf, below) = (self.leaf.max(1), DEPTH.checked_sub(level + 1)?);
        let most = leaf.checked_mul(1_usize.checked_shl(below).unwrap_or(usize::MAX));
        let together = self.together.max(1).next_power_of_two();
        Some(Limits { leaf, together, most: most.unwrap_or(usize::MAX) })
    }
}

/// Adds a subtree that was built apart; gives its root.
fn append(nodes: &mut Vec<Node>, root: Node, below: Vec<Node>) -> Node {
    let moved = nodes.len() as u32;
    let moved = |node: Node| if node.is_leaf() { node } else { Node { first: node.first + moved, ..node } };
    nodes.extend(below.into_iter().map(moved));
    moved(root)
}

/// Runs both, on two threads where there are two. What they do does not depend on it.
#[cfg(feature = "native")]
fn both<L: Send, R: Send>(left: impl FnOnce() -> L + Send, right: impl FnOnce() -> R + Send) -> (L, R) {
    rayon::join(left, right)
}

#[cfg(not(feature = "native"))]
fn both<L, R>(left: impl FnOnce() -> L, right: impl FnOnce() -> R) -> (L, R) {
    (left(), right())
}
