//! AC-08: the walk from one cell to another comes to an end, and leaves out no cell on its way.

use boxes::aabb::Aabb;
use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::cells::Side;
use crate::march::March;
use crate::naive::cells_until_last;
use crate::wide::WideRay;

/// The edge of a cell, and how many there are to either side of the origin.
const EDGE: i64 = 16;
const HALF: i64 = 10;

/// Two different points with whole coordinates: such lines like to go through corners of cells.
fn ends(trial: u64) -> Option<[[i64; 3]; 2]> {
    let mut stream = Stream::of_trial(908, trial);
    let reach = EDGE * HALF;
    let mut end = || [0, 1, 2].map(|_| i64::from(stream.bits()) % (2 * reach + 1) - reach);
    let ends = [end(), end()];
    (ends[0] != ends[1]).then_some(ends)
}

fn point(place: [i64; 3]) -> Vec3 {
    Vec3::from(place.map(|coordinate| coordinate as f32))
}

/// Where a line crosses a border between cells: after `part / whole` of the way.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Crossing {
    part: i64,
    whole: i64,
}

impl Crossing {
    fn before(self, other: Self) -> std::cmp::Ordering {
        (self.part * other.whole).cmp(&(other.part * self.whole))
    }
}

/// The cells through whose inside the line goes, by whole numbers alone: the cell of the middle
/// between each crossing and the next.
fn cover([start, end]: [[i64; 3]; 2]) -> Vec<[i32; 3]> {
    let way = [0, 1, 2].map(|axis| end[axis] - start[axis]);
    let mut crossings = vec![Crossing { part: 0, whole: 1 }, Crossing { part: 1, whole: 1 }];
    for axis in (0..3).filter(|&axis| way[axis] != 0) {
        let (low, high) = (start[axis].min(end[axis]), start[axis].max(end[axis]));
        for border in (-HALF..=HALF).map(|it| it * EDGE).filter(|it| low < *it && *it < high) {
            let sign = way[axis].signum();
            let part = sign * (border - start[axis]);
            crossings.push(Crossing { part, whole: sign * way[axis] });
        }
    }
    crossings.sort_by(|one, other| one.before(*other));
    crossings.dedup_by(|one, other| one.before(*other).is_eq());
    crossings.windows(2).filter_map(|pair| cell_between(start, way, pair[0], pair[1])).collect()
}

/// The cell of the middle between two crossings; None when that runs along a border.
fn cell_between(start: [i64; 3], way: [i64; 3], from: Crossing, to: Crossing) -> Option<[i32; 3]> {
    let (part, whole) = (from.part * to.whole + to.part * from.whole, 2 * from.whole * to.whole);
    let mut cell = [0; 3];
    for axis in 0..3 {
        let place = start[axis] * whole + way[axis] * part;
        if place % (EDGE * whole) == 0 {
            return None;
        }
        cell[axis] = (place.div_euclid(EDGE * whole) + HALF) as i32;
    }
    Some(cell)
}

pub(super) fn walk_naive(trial: u64) -> bool {
    let Some(ends) = ends(trial) else { return false };
    let patience = 3 * (6 * HALF) as usize;
    let shift = |cell: [i32; 3]| cell.map(|index| index + HALF as i32);
    let walked = cells_until_last(point(ends[0]), point(ends[1]), EDGE as f32, patience);
    walked.is_none_or(|cells| {
        let cells: Vec<_> = cells.into_iter().map(shift).collect();
        !cover(ends).iter().all(|cell| cells.contains(cell))
    })
}

pub(super) fn walk_robust(trial: u64) -> bool {
    let Some(ends) = ends(trial) else { return false };
    let reach = (EDGE * HALF) as f32;
    let bounds = Aabb { min: Vec3::splat(-reach), max: Vec3::splat(reach) };
    let side = Side::new(-reach, reach, 2 * HALF as i32);
    let ray = Ray { origin: point(ends[0]), direction: point(ends[1]) - point(ends[0]) };
    let wide = WideRay::new(&ray, &bounds);
    let Some(mut march) = March::start(&wide, &bounds, &[side; 3], 1.0) else { return true };
    let (mut steps, mut cells) = (0, Vec::new());
    while let Some(next) = march.next_cells() {
        steps += 1;
        cells.extend(next);
    }
    steps > 6 * HALF as usize + 3 || !cover(ends).iter().all(|cell| cells.contains(cell))
}

#[cfg(test)]
mod tests {
    use super::{EDGE, HALF, cover, ends, point, walk_naive};
    use crate::naive::cells_until_last;

    #[test]
    fn the_cover_by_hand() {
        // From the middle of one cell through a corner of four into the next but one.
        let cells = cover([[8, 8, 8], [40, 40, 8]]);
        assert_eq!(cells, [[10, 10, 10], [11, 11, 10], [12, 12, 10]]);
        let cells = cover([[-8, 8, 8], [24, 20, 8]]);
        assert_eq!(cells, [[9, 10, 10], [10, 10, 10], [10, 11, 10], [11, 11, 10]]);
    }

    /// The page says how the walk to the last cell fails.
    #[test]
    fn most_naive_failures_are_walks_without_an_end() {
        let patience = 3 * (6 * HALF) as usize;
        let endless = |trial: &u64| {
            ends(*trial).is_some_and(|[start, end]| {
                cells_until_last(point(start), point(end), EDGE as f32, patience).is_none()
            })
        };
        let all = (0..100_000).filter(|trial| walk_naive(*trial)).count();
        let without_end = (0..100_000).filter(endless).count();
        assert!(without_end > all / 2 && without_end <= all, "{without_end} of {all}");
    }
}
