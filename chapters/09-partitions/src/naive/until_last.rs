//! A walk from one cell to another that ends when it comes there.

use glam::Vec3;

// ANCHOR: until_last
/// The cells of edge `size` from that of `start` to that of `end`, as in many programs: the walk
/// ends when it comes to the last cell. A rounding can carry it past that one, and then it never
/// ends (hard case AC-08). None when it has done more than `patience` steps.
pub fn cells_until_last(
    start: Vec3,
    end: Vec3,
    size: f32,
    patience: usize,
) -> Option<Vec<[i32; 3]>> {
    let cell_of = |point: Vec3| (point / size).floor().to_array().map(|it| it as i32);
    let (mut cell, last) = (cell_of(start), cell_of(end));
    let direction = end - start;
    let step = direction.to_array().map(|it| if it > 0.0 { 1 } else { -1 });
    let border = [0, 1, 2].map(|axis| (cell[axis] + i32::from(step[axis] > 0)) as f32 * size);
    let mut next = (Vec3::from(border) - start) / direction;
    let delta = size / direction.abs();
    let mut cells = vec![cell];
    while cell != last {
        let axis = next.min_position();
        cell[axis] += step[axis];
        next[axis] += delta[axis];
        cells.push(cell);
        if cells.len() > patience {
            return None;
        }
    }
    Some(cells)
}
// ANCHOR_END: until_last
