//! Yours to write. Each function is an exercise of the chapter's page; replace its body.
//!
//! ```text
//! cargo test -p partitions --test exercises
//! ```

use glam::Vec3;

/// Exercise 9.1: the cell that a coordinate is in.
///
/// The side of a grid from `low` to `high` is cut into `cells` equal cells, which are numbered from
/// 0. A coordinate on a border belongs to the upper of its two cells, but `high` belongs to the last
/// cell: there is none after it. What is below `low` counts to the first cell, what is above `high`
/// to the last.
///
/// See "Which cell is it?" on the chapter's page.
pub fn cell_of(coordinate: f32, low: f32, high: f32, cells: i32) -> i32 {
    let _ = (coordinate, low, high, cells);
    todo!("exercise 9.1")
}

/// Exercise 9.2: the way through a grid.
///
/// The cells that a line without a width passes, in their order, from the one that `origin` is in to
/// the last before it leaves the grid. The grid has `cells` cells of edge 1 along each axis, and cell
/// [0, 0, 0] has a corner at the origin of coordinates. The line starts inside and doesn't pass
/// through edges or corners of cells. Components of `direction` may be 0 or -0.
///
/// See "From cell to cell" on the chapter's page.
pub fn cells_along(origin: Vec3, direction: Vec3, cells: i32) -> Vec<[i32; 3]> {
    let _ = (origin, direction, cells);
    todo!("exercise 9.2")
}

/// A cell that a ray passes, for exercise 9.3.
#[derive(Clone, Debug, PartialEq)]
pub struct Passed {
    /// Where on the ray it is left.
    pub leaves: f32,
    /// The hits with the triangles that reach into the cell, wherever on the ray the hits are: the
    /// triangle's number and `t`.
    pub hits: Vec<(u32, f32)>,
}

/// The answer to exercise 9.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// The number of the triangle that is hit first, and `t`.
    pub hit: Option<(u32, f32)>,
    /// How many cells were looked into.
    pub cells: usize,
}

/// Exercise 9.3: find the mistake.
///
/// Many programs walk through a grid like this:
///
/// ```text
/// for (number, cell) in cells.iter().enumerate() {
///     if let Some(hit) = nearest of cell.hits {
///         return Nearest { hit: Some(hit), cells: number + 1 };
///     }
/// }
/// ```
///
/// Write it so that it always finds the hit with the least `t`, and of several with the same `t` the
/// triangle with the lowest number. Look into no more cells than needed: stop after a cell that is
/// left at a greater `t` than that of the nearest hit so far.
///
/// See "The first hit that is found" on the chapter's page.
pub fn nearest(cells: &[Passed]) -> Nearest {
    let _ = cells;
    todo!("exercise 9.3")
}

/// Exercise 9.4: a plane in the middle.
///
/// A number halfway between `low` and `high`, to within a thousandth of their distance where there
/// are enough floats between them. It must lie between them and be neither; None where there is no
/// such float. Both are finite, and `low < high`.
///
/// See "Cut in eight" on the chapter's page.
pub fn middle(low: f32, high: f32) -> Option<f32> {
    let _ = (low, high);
    todo!("exercise 9.4")
}

/// Exercise 9.5: what a cut costs.
///
/// The triangle tests that a ray that meets a cell is expected to make, if the cell is cut across x
/// at `part` of its length: `below` triangles are in the part from 0 to `part`, `above` in the other.
/// Rays come from everywhere, so the probability that one that meets the cell also meets a box in it
/// is the ratio of their surfaces. A ray tests all triangles of each part that it meets.
///
/// See "By surface area" on the chapter's page.
pub fn expected_tests(size: Vec3, part: f32, below: u32, above: u32) -> f32 {
    let _ = (size, part, below, above);
    todo!("exercise 9.5")
}
