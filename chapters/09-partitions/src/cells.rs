//! Cells along one side of a grid: which one a coordinate is in, and where they end.

use common::math;

// ANCHOR: side
/// One side of a grid, cut into equal parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Where the first cell begins.
    pub low: f32,
    /// How long a cell is.
    pub cell: f32,
    /// Cells for each unit of length.
    pub per_unit: f32,
    /// How many cells there are, at least 1.
    pub count: i32,
}

impl Side {
    /// From `low` to `high` in `count` cells; in one where so short or so long a side has no
    /// others.
    pub fn new(low: f32, high: f32, count: i32) -> Self {
        let length = high - low;
        let (cell, per_unit) = (length / count as f32, count as f32 / length);
        if cell > 0.0 && cell.is_finite() && per_unit > 0.0 && per_unit.is_finite() {
            return Self { low, cell, per_unit, count };
        }
        Self { low, cell: length.min(f32::MAX), per_unit: 0.0, count: 1 }
    }
    // ANCHOR_END: side

    // ANCHOR: index
    /// The cell that `coordinate` is in; the first or last for one outside, the first for NaN.
    ///
    /// A greater coordinate never gets a lesser cell, because no operation here swaps two numbers.
    /// So a triangle is in every cell from that of its least coordinate to that of its greatest,
    /// wherever rounding puts the borders (hard case AC-09).
    #[inline]
    pub fn index(&self, coordinate: f32) -> i32 {
        let cell = ((coordinate - self.low) * self.per_unit) as i32;
        cell.clamp(0, self.count - 1)
    }
    // ANCHOR_END: index

    /// Where cell `index` begins, from `origin`. For `count` that is where the last cell ends.
    #[inline]
    pub fn border(&self, index: i32, origin: f32) -> f32 {
        (self.low - origin) + index as f32 * self.cell
    }
}

// ANCHOR: cubes
/// How many cells along each side make about `cells` cubes of a box with these sides.
///
/// Cubes of which `dense` stand along a unit of length: the product of length * dense over the three
/// sides is the number of cells. A side shorter than a cube has one, and the two others share what
/// is wanted; so a flat scene gets as many cells as a round one.
pub fn cubes(size: [f32; 3], cells: f32) -> [i32; 3] {
    let longest = size.iter().copied().fold(0.0, f32::max);
    let lengths = size.map(|length| length / longest);
    let mut sides = [0, 1, 2];
    sides.sort_by(|&one, &other| lengths[one].total_cmp(&lengths[other]));
    let mut counts = [1; 3];
    for (shorter, root) in [cube_root, f32::sqrt, |it| it].into_iter().enumerate() {
        let volume: f32 = sides[shorter..].iter().map(|&side| lengths[side]).product();
        let dense = root(cells / volume);
        if lengths[sides[shorter]] * dense >= 1.0 {
            for &side in &sides[shorter..] {
                counts[side] = ((lengths[side] * dense).round() as i32).clamp(1, MOST_A_SIDE);
            }
            break;
        }
    }
    counts
}
// ANCHOR_END: cubes

fn cube_root(value: f32) -> f32 {
    math::pow(value, 1.0 / 3.0)
}

/// The most cells along a side.
pub const MOST_A_SIDE: i32 = 1024;

#[cfg(test)]
mod tests {
    use super::{MOST_A_SIDE, Side, cubes};

    /// AC-09: every one of 65,536 floats from each end inward has a cell that is there, and a greater
    /// one never gets a lesser cell.
    #[test]
    fn every_float_at_the_ends_has_a_cell() {
        for (low, high) in
            [(0.0_f32, 1.0), (1e6, 1e6 + 1.0), (-3.0, 5.5), (-1e-40, 1e-38), (0.3, 7e37)]
        {
            for count in [1, 3, 64, 300] {
                let side = Side::new(low, high, count);
                let (mut up, mut down) = (low, high);
                for _ in 0..65_536 {
                    let [first, last] = [up, down].map(|place| side.index(place));
                    (up, down) = (up.next_up(), down.next_down());
                    assert!(first >= 0 && last < count);
                    assert!(first <= side.index(up) && last >= side.index(down));
                }
                assert_eq!([side.index(low), side.index(high)], [0, side.count - 1]);
            }
        }
    }

    #[test]
    fn what_is_outside_belongs_to_an_end_and_nonsense_to_the_first_cell() {
        let side = Side::new(2.0, 4.0, 8);
        let outside = [f32::NEG_INFINITY, -1e30, 1.9, 4.1, 1e30, f32::INFINITY, f32::NAN];
        assert_eq!(outside.map(|place| side.index(place)), [0, 0, 0, 7, 7, 7, 0]);
        assert_eq!((side.border(3, 0.5), side.border(8, 0.0)), (2.25, 4.0));
    }

    #[test]
    fn a_side_too_short_or_too_long_is_one_cell() {
        for (low, high) in [(1.0, 1.0), (0.0, 1e-45), (-f32::MAX, f32::MAX), (-0.0, 0.0)] {
            let side = Side::new(low, high, 100);
            assert_eq!((side.count, side.index(low), side.index(high)), (1, 0, 0));
        }
    }

    #[test]
    fn cubes_of_a_lopsided_box_a_plate_a_rod_and_a_point() {
        // 2 by 4 by 8 in 512 cubes of edge 1/2.
        assert_eq!(cubes([4.0, 2.0, 8.0], 512.0), [8, 4, 16]);
        assert_eq!(cubes([3.0, 0.0, 12.0], 100.0), [5, 1, 20]);
        assert_eq!(cubes([3.0, 1e-20, 12.0], 100.0), [5, 1, 20]);
        assert_eq!(cubes([0.0, 5.0, 0.0], 77.0), [1, 77, 1]);
        assert_eq!(cubes([0.0; 3], 1000.0), [1; 3]);
        assert_eq!(cubes([1e38; 3], 1e30), [MOST_A_SIDE; 3]);
        assert_eq!(cubes([f32::INFINITY, 1.0, 1.0], 1000.0), [1; 3]);
    }
}
