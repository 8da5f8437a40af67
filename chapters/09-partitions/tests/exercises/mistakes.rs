//! What readers get wrong.

mod walks;

use common::exercise::Mistake;
use partitions::exercises::{Nearest, Passed};

use crate::cases::{Cell, Coordinate, Cut};

pub(crate) use walks::cells_along;

/// Of exercise 9.1.
pub(crate) fn cell_of() -> Vec<Mistake<Coordinate, i32>> {
    vec![
        Mistake {
            name: "one past the last",
            diagnosis: "You give the upper end a cell of its own, which isn't there. Hold the number \
                        between 0 and cells - 1.",
            answer: |it| (part(it) * it.cells as f32).floor() as i32,
        },
        Mistake {
            name: "one cell too few",
            diagnosis: "You multiply by cells - 1, so that the upper end comes out right. Then all \
                        other borders are wrong. Multiply by cells, and hold the last one back.",
            answer: |it| ((part(it) * (it.cells - 1) as f32) as i32).clamp(0, it.cells - 1),
        },
        Mistake {
            name: "rounded",
            diagnosis: "You round to the nearest number. A coordinate belongs to the cell whose \
                        border is below it: round down.",
            answer: |it| ((part(it) * it.cells as f32).round() as i32).clamp(0, it.cells - 1),
        },
        Mistake {
            name: "counted from the origin",
            diagnosis: "You count cells from the origin of coordinates. Subtract low before you \
                        multiply.",
            answer: |it| {
                let dense = it.cells as f32 / (it.high - it.low);
                ((it.coordinate * dense) as i32).clamp(0, it.cells - 1)
            },
        },
        Mistake {
            name: "subtracted too late",
            diagnosis: "You multiply coordinate and low apart and subtract then. Far from the origin \
                        both products are rounded by more than a cell. Subtract first.",
            answer: |it| {
                let dense = it.cells as f32 / (it.high - it.low);
                let cell = (it.coordinate * dense - it.low * dense) as i32;
                cell.clamp(0, it.cells - 1)
            },
        },
    ]
}

fn part(it: &Coordinate) -> f32 {
    (it.coordinate - it.low) / (it.high - it.low)
}

/// Of exercise 9.3.
pub(crate) fn nearest() -> Vec<Mistake<Vec<Passed>, Nearest>> {
    vec![
        Mistake {
            name: "the first hit that is found",
            diagnosis: "You stop with the first hit, as the published loop does. Its triangle reaches \
                        into this cell, but is hit in a later one, and another may be in front of it \
                        there. Keep it, and stop only when a cell ends behind it.",
            answer: |cells| search(cells, closer, |_, _| true),
        },
        Mistake {
            name: "the first in the list",
            diagnosis: "You take the first hit of a cell. A cell has several triangles in no order: \
                        keep the least t of all.",
            answer: |cells| search(cells, |_, _| false, |t, leaves| t < leaves),
        },
        Mistake {
            name: "never stops",
            diagnosis: "You find the right hit, but look into every cell. Nothing nearer can come \
                        after a cell that is left behind the hit: stop there.",
            answer: |cells| search(cells, closer, |_, _| false),
        },
        Mistake {
            name: "no rule for equals",
            diagnosis: "Of two hits at the same t you keep the one that was found first. Which that \
                        is depends on the cells. Let the triangle with the lowest number win.",
            answer: |cells| search(cells, |hit, best| hit.1 < best.1, |t, leaves| t < leaves),
        },
        Mistake {
            name: "stops at the border",
            diagnosis: "You stop when the hit is exactly where the cell ends. A triangle of the next \
                        cell can be hit at the same t, and have a lower number: stop only if t is \
                        less.",
            answer: |cells| search(cells, closer, |t, leaves| t <= leaves),
        },
        Mistake {
            name: "no rule for equals, and stops at the border",
            diagnosis: "Two things. Of two hits at the same t you keep the one that was found first: \
                        let the triangle with the lowest number win. And you stop when the hit is \
                        exactly where the cell ends, though the next cell can have one at the same t, \
                        with a lower number: stop only if t is less. See 'The first hit that is \
                        found'.",
            answer: |cells| search(cells, |hit, best| hit.1 < best.1, |t, leaves| t <= leaves),
        },
        Mistake {
            name: "the last of equals",
            diagnosis: "Of two hits at the same t you keep the one that was found last. Which that \
                        is depends on the cells. Let the triangle with the lowest number win. See \
                        'The first hit that is found'.",
            answer: |cells| search(cells, |hit, best| hit.1 <= best.1, |t, leaves| t < leaves),
        },
        Mistake {
            name: "the last of equals, and stops at the border",
            diagnosis: "Two things. Of two hits at the same t you keep the one that was found last: \
                        let the triangle with the lowest number win. And you stop when the hit is \
                        exactly where the cell ends, though the next cell can have one at the same t, \
                        with a lower number: stop only if t is less. See 'The first hit that is \
                        found'.",
            answer: |cells| search(cells, |hit, best| hit.1 <= best.1, |t, leaves| t <= leaves),
        },
        Mistake {
            name: "the first hit that is found, and no rule for equals",
            diagnosis: "You stop with the first cell that has a hit, as the published loop does; the \
                        hit may be in a later cell, behind another one. Stop only when a cell ends \
                        behind it. Then, of hits at the same t, let the triangle with the lowest \
                        number win. See 'The first hit that is found'.",
            answer: |cells| search(cells, |hit, best| hit.1 < best.1, |_, _| true),
        },
        Mistake {
            name: "never stops, and no rule for equals",
            diagnosis: "You look into every cell, and of two hits at the same t you keep the one that \
                        was found first. Stop after a cell that is left behind the hit: nothing \
                        nearer can come. And let the triangle with the lowest number win. See 'The \
                        first hit that is found'.",
            answer: |cells| search(cells, |hit, best| hit.1 < best.1, |_, _| false),
        },
    ]
}

fn closer(hit: (u32, f32), best: (u32, f32)) -> bool {
    (hit.1, hit.0) < (best.1, best.0)
}

fn search(
    cells: &[Passed],
    replaces: impl Fn((u32, f32), (u32, f32)) -> bool,
    stops: impl Fn(f32, f32) -> bool,
) -> Nearest {
    let mut nearest: Option<(u32, f32)> = None;
    for (number, cell) in cells.iter().enumerate() {
        for &hit in &cell.hits {
            if nearest.is_none_or(|best| replaces(hit, best)) {
                nearest = Some(hit);
            }
        }
        if nearest.is_some_and(|(_, t)| stops(t, cell.leaves)) {
            return Nearest { hit: nearest, cells: number + 1 };
        }
    }
    Nearest { hit: nearest, cells: cells.len() }
}

/// Of exercise 9.4.
pub(crate) fn middle() -> Vec<Mistake<Cell, Option<f32>>> {
    vec![
        Mistake {
            name: "the sum overflows",
            diagnosis: "You add before you halve. Above 1.7e38 the sum is infinite. Halve both, then \
                        add.",
            answer: |it| between(it, 0.5 * (it.low + it.high)),
        },
        Mistake {
            name: "the difference overflows",
            diagnosis: "You add half of the difference to low. From -3e38 to 2e38 the difference is \
                        infinite. Halve both, then add.",
            answer: |it| between(it, it.low + 0.5 * (it.high - it.low)),
        },
        Mistake {
            name: "no progress",
            diagnosis: "You give back an end of the cell when there is no float between. Cut there, \
                        and one half is the cell again: a builder would go on for ever. Say None.",
            answer: |it| Some(0.5 * it.low + 0.5 * it.high),
        },
        Mistake {
            name: "an epsilon",
            diagnosis: "You call a cell too narrow by a number of units. Whether there is a float \
                        between depends on where the cell is. Compare the middle with both ends.",
            answer: |it| (it.high - it.low > 1e-6).then_some(0.5 * it.low + 0.5 * it.high),
        },
    ]
}

fn between(cell: &Cell, middle: f32) -> Option<f32> {
    (cell.low < middle && middle < cell.high).then_some(middle)
}

/// Of exercise 9.5.
pub(crate) fn expected_tests() -> Vec<Mistake<Cut, f32>> {
    vec![
        Mistake {
            name: "by volume",
            diagnosis: "You weighted the counts by volumes. A ray meets a thin plate far more often \
                        than its volume says: it is surfaces that count.",
            answer: |it| it.part * it.below as f32 + (1.0 - it.part) * it.above as f32,
        },
        Mistake {
            name: "both for certain",
            diagnosis: "You added the counts. A ray that meets the cell need not meet both parts: \
                        weigh each by its share of the surface.",
            answer: |it| (it.below + it.above) as f32,
        },
        Mistake {
            name: "not a ratio",
            diagnosis: "You weighted by the parts' surfaces and did not divide by the cell's. A \
                        probability is a ratio.",
            answer: |it| {
                let (below, above) = surfaces(it);
                below * it.below as f32 + above * it.above as f32
            },
        },
        Mistake {
            name: "shares that sum to one",
            diagnosis: "You divided by the sum of the parts' surfaces. The plane between them counts \
                        for both, and many rays meet both: divide by the cell's surface.",
            answer: |it| {
                let (below, above) = surfaces(it);
                (below * it.below as f32 + above * it.above as f32) / (below + above)
            },
        },
    ]
}

fn surfaces(it: &Cut) -> (f32, f32) {
    let surface = |x: f32| 2.0 * (x * (it.size.y + it.size.z) + it.size.y * it.size.z);
    (surface(it.part * it.size.x), surface((1.0 - it.part) * it.size.x))
}
