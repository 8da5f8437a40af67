//! The same questions in numbers so wide that nothing overflows or rounds: the oracle.

use crate::fixed::Fixed;

/// Whether a triangle owns a sample by the top-left rule, in 128-bit whole numbers.
///
/// Written apart from [`crate::edge`], so that a mistake there is not made here too.
pub fn wide_covers([a, b, c]: [Fixed; 3], sample: Fixed) -> bool {
    let value = |from: Fixed, to: Fixed, at: Fixed| {
        let wide = |from: i32, to: i32| i128::from(to) - i128::from(from);
        wide(from.x, to.x) * wide(from.y, at.y) - wide(from.y, to.y) * wide(from.x, at.x)
    };
    let area = value(a, b, c);
    let [b, c] = if area > 0 { [b, c] } else { [c, b] };
    let owns = |from: Fixed, to: Fixed| {
        let top_left = to.y < from.y || (to.y == from.y && to.x > from.x);
        value(from, to, sample) >= i128::from(!top_left)
    };
    area != 0 && owns(a, b) && owns(b, c) && owns(c, a)
}
