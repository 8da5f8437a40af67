//! The solutions.

use glam::Vec3;
use partitions::exercises::{Nearest, Passed};

/// Exercise 9.1.
pub(crate) fn cell_of(coordinate: f32, low: f32, high: f32, cells: i32) -> i32 {
    let cell = ((coordinate - low) / (high - low) * cells as f32) as i32;
    cell.clamp(0, cells - 1)
}

/// Exercise 9.2.
pub(crate) fn cells_along(origin: Vec3, direction: Vec3, cells: i32) -> Vec<[i32; 3]> {
    let inverse = direction.recip();
    let step = inverse.to_array().map(|it| if it > 0.0 { 1 } else { -1 });
    let mut cell = origin.floor().to_array().map(|it| it as i32);
    let mut passed = Vec::new();
    while cell.iter().all(|index| (0..cells).contains(index)) {
        passed.push(cell);
        let leaves = [0, 1, 2].map(|axis| {
            let border = cell[axis] + i32::from(step[axis] > 0);
            (border as f32 - origin[axis]) * inverse[axis]
        });
        let axis = Vec3::from(leaves).min_position();
        cell[axis] += step[axis];
    }
    passed
}

/// Exercise 9.3.
pub(crate) fn nearest(cells: &[Passed]) -> Nearest {
    let mut nearest: Option<(u32, f32)> = None;
    for (number, cell) in cells.iter().enumerate() {
        for &(triangle, t) in &cell.hits {
            if nearest.is_none_or(|best| (t, triangle) < (best.1, best.0)) {
                nearest = Some((triangle, t));
            }
        }
        if nearest.is_some_and(|(_, t)| t < cell.leaves) {
            return Nearest { hit: nearest, cells: number + 1 };
        }
    }
    Nearest { hit: nearest, cells: cells.len() }
}

/// Exercise 9.4.
pub(crate) fn middle(low: f32, high: f32) -> Option<f32> {
    let middle = 0.5 * low + 0.5 * high;
    (low < middle && middle < high).then_some(middle)
}

/// Exercise 9.5.
pub(crate) fn expected_tests(size: Vec3, part: f32, below: u32, above: u32) -> f32 {
    let surface = |along: f32| along * (size.y + size.z) + size.y * size.z;
    let (lower, upper) = (surface(part * size.x), surface((1.0 - part) * size.x));
    (lower * below as f32 + upper * above as f32) / surface(size.x)
}
