//! Where to cut a set of items in two.

use crate::bins::{Slabs, cheapest};
use crate::item::{Item, Span};

/// How a node's items are cut in two.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Split {
    /// Through the middle of the longest axis
    Midpoint,
    /// So that both sides have as many
    Median,
    /// Where the boxes' surfaces promise the least work
    #[default]
    Sah,
}

/// What a cut may do.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// The most items of a leaf.
    pub(crate) leaf: usize,
    /// How many items are asked for the price of one.
    pub(crate) together: u32,
    /// The most items that either side may have.
    pub(crate) most: usize,
}

/// What reading a node and testing its two children's boxes costs, where asking a group of items
/// costs 1.
pub(crate) const STEP: f32 = 0.5;

// ANCHOR: cut
/// Sorts the items into two sides and says how many the first has. None for a leaf.
///
/// Whatever the method says, a set too large for a leaf is cut, neither side is empty, and neither
/// has more than the limit: where a method can't do that, the median can.
pub(crate) fn cut(
    items: &mut [Item],
    bounds: &Span,
    centers: &Span,
    split: Split,
    limits: Limits,
) -> Option<usize> {
    let small = items.len() <= limits.leaf;
    let middle = match split {
        Split::Midpoint if !small => midpoint(items, centers),
        Split::Median if !small => 0,
        Split::Sah if !small || items.len() > limits.together as usize => {
            by_area(items, bounds, centers, small, limits.together)?
        }
        _ => return None,
    };
    let lopsided = middle == 0 || middle.max(items.len() - middle) > limits.most;
    Some(if lopsided { median(items, centers) } else { middle })
}
// ANCHOR_END: cut

/// The axis along which the span is longest.
fn longest(span: &Span) -> usize {
    (span.high - span.low).truncate().max_position()
}

// ANCHOR: midpoint
/// Cuts the longest axis of the centres through its middle.
fn midpoint(items: &mut [Item], centers: &Span) -> usize {
    let axis = longest(centers);
    let middle = 0.5 * centers.low[axis] + 0.5 * centers.high[axis];
    partition(items, |item| item.center()[axis] < middle)
}
// ANCHOR_END: midpoint

// ANCHOR: median
/// Cuts so that both sides have as many, along the longest axis of the centres. Of items at the
/// same place the number decides, so that the result does not depend on how they came.
fn median(items: &mut [Item], centers: &Span) -> usize {
    let axis = longest(centers);
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |left, right| {
        let places = left.center()[axis].total_cmp(&right.center()[axis]);
        places.then(left.index().cmp(&right.index()))
    });
    middle
}
// ANCHOR_END: median

// ANCHOR: by_area
/// Cuts where the surface area heuristic finds it cheapest; 0 where it finds nothing. None when a
/// leaf is cheaper still.
fn by_area(
    items: &mut [Item],
    bounds: &Span,
    centers: &Span,
    small: bool,
    together: u32,
) -> Option<usize> {
    let slabs = Slabs::new(centers, items.len());
    let best = cheapest(items, bounds, &slabs, together);
    let leaf = (items.len() as u32).div_ceil(together) as f32;
    if small && best.is_none_or(|best| STEP + best.cost >= leaf) {
        return None;
    }
    Some(best.map_or(0, |plane| partition(items, |item| slabs.is_below(item, &plane))))
}
// ANCHOR_END: by_area

/// Moves the items of which `is_first` is true to the front, and says how many there are.
fn partition(items: &mut [Item], is_first: impl Fn(&Item) -> bool) -> usize {
    let (mut front, mut back) = (0, items.len());
    while front < back {
        if is_first(&items[front]) {
            front += 1;
        } else {
            back -= 1;
            items.swap(front, back);
        }
    }
    front
}
