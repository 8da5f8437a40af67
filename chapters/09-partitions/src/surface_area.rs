//! The surface area heuristic: cut where a ray is expected to make the fewest tests.
//!
//! MacDonald and Booth, "Heuristics for Ray Tracing Using Space Subdivision" (The Visual Computer
//! 6, 1990); planes at a few places only, by bins: Popov, Günther, Seidel and Slusallek,
//! "Experiences with Streaming Construction of SAH KD-Trees" (Symposium on Interactive Ray Tracing
//! 2006).

use crate::plant::{Cell, Plane, Span};

/// Parts that a side of a cell is divided into. Planes are tried where they meet.
const BINS: usize = 16;

/// What a visit to an inner node costs, in triangle tests: the sum of two costs in the chapter's
/// experiments.
const VISIT: f32 = 1.0;

/// What is left of the cost of a cut that makes an empty cell: rays end there without a test, and
/// the sum below doesn't see that (Wald and Havran 2006, section 3.3).
const WITH_EMPTY_CELL: f32 = 0.8;

// ANCHOR: cheapest
/// The cheapest plane, if one is cheaper than asking all members.
///
/// A ray that meets the cell meets a box in it with a probability that is the ratio of their
/// surfaces. So a cut costs, in triangle tests, a visit and the members of each half times its share
/// of the surface.
pub fn cheapest(cell: &Cell<3>) -> Option<Plane> {
    let mut best = None;
    let mut lowest = cell.members.len() as f32;
    for direction in 0..3 {
        let surface = Surface::across(direction, &cell.extent);
        let [starts, ends] = binned(cell, direction);
        let [mut below, mut above] = [0, cell.members.len()];
        for border in 1..BINS {
            below += starts[border - 1];
            above -= ends[border - 1];
            let part = border as f32 / BINS as f32;
            let cost = surface.cost(part, below, above);
            // Never true for the NaN that an endless or vanishing surface gives (hard case AC-03).
            if cost < lowest {
                lowest = cost;
                best = Some(Plane { direction, place: between(cell.extent[direction], part) });
            }
        }
    }
    best
}

/// A cell's surface, as a plane across one direction divides it.
struct Surface {
    /// The share of the two faces across that direction together.
    end: f32,
    /// The share of the four others together.
    sides: f32,
}

impl Surface {
    fn across(direction: usize, extent: &[Span; 3]) -> Self {
        let length = |at: usize| extent[at % 3].high - extent[at % 3].low;
        // In units of the longest side: products of the lengths themselves could overflow.
        let unit = length(0).max(length(1)).max(length(2));
        let [along, across, up] = [0, 1, 2].map(|turn| length(direction + turn) / unit);
        let [end, sides] = [across * up, along * (across + up)];
        Self { end: end / (end + sides), sides: sides / (end + sides) }
    }

    /// What a cut costs that leaves this part of the length below it, and so many members on either
    /// side.
    fn cost(&self, part: f32, below: usize, above: usize) -> f32 {
        let lower = self.end + part * self.sides;
        let upper = self.end + (1.0 - part) * self.sides;
        let factor = if below == 0 || above == 0 { WITH_EMPTY_CELL } else { 1.0 };
        VISIT + factor * (lower * below as f32 + upper * above as f32)
    }
}
// ANCHOR_END: cheapest

/// The place that leaves this part of the cell below it.
fn between(extent: Span, part: f32) -> f32 {
    (1.0 - part) * extent.low + part * extent.high
}

/// How many members begin in each part of the cell, and how many end there.
fn binned(cell: &Cell<3>, direction: usize) -> [[usize; BINS]; 2] {
    let Span { low, high } = cell.extent[direction];
    let bin = |place: f32| {
        let part = (place - low) / (high - low) * BINS as f32;
        // NaN becomes 0. Members reach out of the cell.
        (part as i32).clamp(0, BINS as i32 - 1) as usize
    };
    let mut bins = [[0; BINS]; 2];
    for span in cell.spans_along(direction) {
        bins[0][bin(span.low)] += 1;
        bins[1][bin(span.high)] += 1;
    }
    bins
}

#[cfg(test)]
mod tests {
    use super::{Surface, VISIT, WITH_EMPTY_CELL, cheapest};
    use crate::plant::{Cell, Span};

    fn extent(size: [f32; 3]) -> [Span; 3] {
        size.map(|length| Span { low: -1.0, high: length - 1.0 })
    }

    /// A box of 1 by 2 by 3 has a surface of 22, and a quarter of it along x one of 14.5.
    #[test]
    fn a_cost_by_hand() {
        let cost = Surface::across(0, &extent([1.0, 2.0, 3.0])).cost(0.25, 4, 8);
        assert!((cost - (VISIT + (14.5 * 4.0 + 19.5 * 8.0) / 22.0)).abs() < 1e-5, "{cost}");
        let cost = Surface::across(2, &extent([1.0, 2.0, 3.0])).cost(0.5, 0, 6);
        assert!((cost - (VISIT + WITH_EMPTY_CELL * 13.0 * 6.0 / 22.0)).abs() < 1e-5, "{cost}");
    }

    /// AC-03: the largest and the smallest boxes have costs, or none that is chosen.
    #[test]
    fn no_size_gives_a_wrong_choice() {
        for size in [0.0, 1e-45, 1e-30, 1e20, 3e38, f32::INFINITY] {
            let extent = [size, size, 0.0].map(|high| Span { low: 0.0, high });
            let quarter = |part: usize| {
                extent.map(|Span { high, .. }| Span {
                    low: high / 4.0 * part as f32,
                    high: high / 4.0 * (part + 1) as f32,
                })
            };
            let spans: Vec<_> = (0..64).map(|number| quarter(number % 4)).collect();
            let members: Vec<u32> = (0..64).collect();
            let plane = cheapest(&Cell { spans: &spans, members: &members, extent });
            let Some(plane) = plane else { continue };
            let Span { low, high } = extent[plane.direction];
            assert!(low <= plane.place && plane.place <= high, "{size}: {plane:?}");
        }
    }
}
