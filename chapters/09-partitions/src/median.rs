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

#[cfg(test)]
mod tests {
    use super::{counts, median};
    use crate::plant::{Cell, Span};

    #[test]
    fn the_middle_of_five_and_who_is_on_which_side() {
        let spans = [(0.0, 2.0), (9.0, 9.5), (4.0, 4.0), (-6.0, 1.0), (4.0, 8.0)];
        let spans = spans.map(|(low, high)| [Span { low, high }]);
        let extent = [Span { low: -6.0, high: 9.5 }];
        let cell = Cell { spans: &spans, members: &[0, 1, 2, 3, 4], extent };
        assert_eq!(median(&cell, 0), 4.0);
        // One that lies in the plane is below, one that begins there is above.
        assert_eq!(counts(cell.spans_along(0), 4.0), [3, 2]);
        assert_eq!(counts(cell.spans_along(0), 0.5), [2, 5]);
        let few = Cell { members: &[1, 3], ..cell };
        assert_eq!(median(&few, 0), 9.25);
    }
}
