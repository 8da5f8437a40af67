//! What a builder sorts: boxes with numbers, in a layout the processor likes.

use boxes::aabb::Aabb;
use glam::Vec4;

// ANCHOR: item
/// The box of one thing, and the thing's number: 32 bytes.
///
/// The number hides in the fourth lane of `low`, so that a box can grow by two operations on four
/// lanes. There it must look like an ordinary `f32`, for some processors are slow with others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Item {
    low: Vec4,
    high: Vec4,
}
// ANCHOR_END: item

/// The exponent that makes a number's bits an ordinary `f32`.
const ORDINARY: u32 = 0x4000_0000;
/// The most things a tree can hold.
pub(crate) const MOST: usize = 1 << 29;

impl Item {
    /// Thing number `index`. None when its box is empty, or is not finite: no ray could hit what is
    /// in it, and in the tree it would spoil every box around it (hard case AC-05).
    pub(crate) fn new(bounds: &Aabb, index: u32) -> Option<Self> {
        let sound = bounds.min.is_finite()
            && bounds.max.is_finite()
            && bounds.min.cmple(bounds.max).all()
            && (index as usize) < MOST;
        let number = f32::from_bits(ORDINARY | index);
        sound.then_some(Self { low: bounds.min.extend(number), high: bounds.max.extend(0.0) })
    }

    /// The thing's number.
    pub(crate) fn index(&self) -> u32 {
        self.low.w.to_bits() & !ORDINARY
    }

    // ANCHOR: center
    /// Half the box's centre. The centre itself could lie farther than the largest `f32` from
    /// another one; of halves, every difference is finite. The fourth lane means nothing.
    #[inline]
    pub(crate) fn center(&self) -> Vec4 {
        0.25 * self.low + 0.25 * self.high
    }
    // ANCHOR_END: center
}

/// A box that grows; its fourth lanes mean nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub(crate) low: Vec4,
    pub(crate) high: Vec4,
}

impl Span {
    /// The box of nothing.
    pub(crate) const EMPTY: Self = Self { low: Vec4::INFINITY, high: Vec4::NEG_INFINITY };

    /// Takes in an item's box.
    #[inline]
    pub(crate) fn add(&mut self, item: &Item) {
        self.low = self.low.min(item.low);
        self.high = self.high.max(item.high);
    }

    /// Takes in a point.
    #[inline]
    pub(crate) fn add_point(&mut self, point: Vec4) {
        self.low = self.low.min(point);
        self.high = self.high.max(point);
    }

    /// Takes in another box.
    #[inline]
    pub(crate) fn join(&mut self, other: &Self) {
        self.low = self.low.min(other.low);
        self.high = self.high.max(other.high);
    }

    /// The same as a box.
    pub(crate) fn aabb(&self) -> Aabb {
        Aabb { min: self.low.truncate(), max: self.high.truncate() }
    }
}
