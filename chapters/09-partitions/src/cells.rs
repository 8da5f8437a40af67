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
