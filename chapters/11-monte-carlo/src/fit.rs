//! Whether samples follow the density they claim.

use common::sampler::Stream;
use glam::{DVec2, Vec2};

/// Cells along a side of the unit square: 64 in all.
pub const SIDE: usize = 8;

/// Places along a side of a cell at which its density is asked for.
const STEPS: usize = 16;

// ANCHOR: counts
/// How many of `samples` random points fall into each cell of the unit square.
///
/// `warp` takes a uniform point to the place that is tested, and then to coordinates of that place
/// which fill the unit square, such as height and angle.
pub fn counts(seed: u64, samples: u64, warp: impl Fn(Vec2) -> Vec2) -> Vec<u64> {
    let mut counts = vec![0; SIDE * SIDE];
    for trial in 0..samples {
        let place = warp(Stream::of_trial(seed, trial).uniform2()) * SIDE as f32;
        // The upper end belongs to the last cell.
        let [column, row] = place.to_array().map(|along| (along as usize).min(SIDE - 1));
        counts[row * SIDE + column] += 1;
    }
    counts
}

/// How many are to be expected, by a density over the unit square of these coordinates.
pub fn expected(samples: u64, density: impl Fn(DVec2) -> f64) -> Vec<f64> {
    let per_step = samples as f64 / (SIDE * SIDE * STEPS * STEPS) as f64;
    let all = SIDE * STEPS;
    let mut expected = vec![0.0; SIDE * SIDE];
    for (row, column) in (0..all).flat_map(|row| (0..all).map(move |column| (row, column))) {
        let place = (DVec2::new(column as f64, row as f64) + 0.5) / all as f64;
        expected[row / STEPS * SIDE + column / STEPS] += per_step * density(place);
    }
    expected
}
// ANCHOR_END: counts

// ANCHOR: coordinates
/// The coordinates of a direction whose height z is at least `lowest`: where its height is between
/// that and 1, and its angle around z as a part of the full turn.
///
/// A patch of directions has the solid angle dz dφ (Archimedes), so a density p per steradian is
/// 2π (1 - lowest) p here.
pub fn of_direction(direction: glam::Vec3, lowest: f32) -> Vec2 {
    let turn = common::math::atan2(direction.y, direction.x) / std::f32::consts::TAU;
    Vec2::new((direction.z - lowest) / (1.0 - lowest), turn + if turn < 0.0 { 1.0 } else { 0.0 })
}
// ANCHOR_END: coordinates

/// The coordinates of a point of the unit disk: the square of its radius, and its angle as a part of
/// the full turn. A patch has the area dr² dφ / 2, so a density p per area is π p here.
pub fn of_disk(point: Vec2) -> Vec2 {
    let turn = common::math::atan2(point.y, point.x) / std::f32::consts::TAU;
    Vec2::new(point.length_squared(), turn + if turn < 0.0 { 1.0 } else { 0.0 })
}
