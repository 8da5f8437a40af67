//! The nodes of a tree, flat in one list.

use boxes::aabb::Aabb;

// ANCHOR: node
/// A box, and what is in it: 32 bytes, of which two fill a line of the processor's cache.
///
/// An inner node's children lie side by side, so one number finds both.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Node {
    /// Around everything below.
    pub bounds: Aabb,
    /// Of an inner node, the first child's place among the nodes; of a leaf, the place of its first
    /// item in the order.
    pub first: u32,
    /// Of a leaf, how many items it has; 0 for an inner node.
    pub count: u32,
}
// ANCHOR_END: node

impl Node {
    /// Whether it has items and no children.
    #[inline]
    pub fn is_leaf(&self) -> bool {
        self.count > 0
    }

    /// The children's places; of an inner node only.
    #[inline]
    pub fn children(&self) -> [usize; 2] {
        [self.first as usize, self.first as usize + 1]
    }

    /// The place of its children in a list of pairs that leaves out the root; of an inner node only.
    #[inline]
    pub(crate) fn pair(&self) -> usize {
        (self.first as usize - 1) / 2
    }

    /// The places of its items in the order; of a leaf only.
    #[inline]
    pub fn items(&self) -> std::ops::Range<usize> {
        self.first as usize..(self.first + self.count) as usize
    }
}
