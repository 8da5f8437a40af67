//! The median: as many triangles on one side as on the other.

use crate::plant::{Cell, Span};

// ANCHOR: median
/// The middle one of the members' own middles along `direction`. The cell has members.
pub fn median<const N: usize>(cell: &Cell<N>, direction: usize) -> f32 {
    let mut middles: Vec<f32> = cell.spans_along(direction).map(|span| span.middle()).collect();
    let half = middles.len() / 2;
    *middles.select_nth_unstable_by(half, f32::total_cmp).1
}
// ANCHOR_END: median

/// How many spans reach below `place`, and how many above it.
pub fn counts(spans: impl Iterator<Item = Span>, place: f32) -> [usize; 2] {
    spans.fold([0, 0], |[below, above], span| {
        let is_below = span.low < place || span.high <= place;
        [below + usize::from(is_below), above + usize::from(span.high > place)]
    })
}
