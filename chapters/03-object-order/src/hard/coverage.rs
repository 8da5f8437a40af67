//! RA-01 and RA-05: which triangle owns a sample.

use common::sampler::Stream;
use glam::Vec2;

use crate::edge::{covers, edges};
use crate::fixed::Fixed;
use crate::naive::{float_covers, narrow_covers};
use crate::reference::wide_covers;

/// A square cut into four triangles that meet at a point, and a sample on one of the cuts.
pub struct Fan {
    /// The four, each with the meeting point first.
    pub triangles: [[Vec2; 3]; 4],
    /// The sample.
    pub sample: Vec2,
}

/// Pixels along a side of the square.
pub(super) const SIDE: f32 = 64.0;

/// The fan of trial number `trial`.
pub fn fan(trial: u64) -> Fan {
    let mut stream = Stream::of_trial(301, trial);
    let middle = Vec2::splat(1.0) + stream.uniform2() * (SIDE - 2.0);
    let triangles = around(middle);
    let corner = triangles[(stream.bits() % 4) as usize][1];
    // Every eighth sample is the point where all four meet. None gets as far as the corner, whose
    // outer side belongs to nobody.
    let share = if trial.is_multiple_of(8) { 0.0 } else { 0.97 * stream.uniform() };
    Fan { triangles, sample: middle + share * (corner - middle) }
}

/// The square's four triangles that meet at `middle`, each with that point first.
pub(super) fn around(middle: Vec2) -> [[Vec2; 3]; 4] {
    let corners = [[0.0, 0.0], [SIDE, 0.0], [SIDE, SIDE], [0.0, SIDE]].map(Vec2::from);
    std::array::from_fn(|side| [middle, corners[side], corners[(side + 1) % 4]])
}

/// How many triangles own the sample, by `f32` edge functions.
pub(super) fn float_owners(fan: &Fan) -> usize {
    fan.triangles.iter().filter(|&&triangle| float_covers(triangle, fan.sample)).count()
}

/// How many own it when all points are snapped first.
pub(super) fn fixed_owners(fan: &Fan) -> usize {
    let snap = |point: Vec2| Fixed::snap(point.as_dvec2());
    let owns = |triangle: &[Vec2; 3]| {
        edges(triangle.map(snap)).is_some_and(|edges| covers(&edges, snap(fan.sample)))
    };
    fan.triangles.iter().filter(|triangle| owns(triangle)).count()
}

/// RA-01, naive.
pub(super) fn float_edges_fail(trial: u64) -> bool {
    float_owners(&fan(trial)) != 1
}

/// RA-01, robust.
pub(super) fn fixed_edges_fail(trial: u64) -> bool {
    fixed_owners(&fan(trial)) != 1
}

/// A triangle with corners anywhere in the guard band, and a sample on the film.
struct Wide {
    corners: [Fixed; 3],
    sample: Fixed,
}

fn wide(trial: u64) -> Wide {
    let mut stream = Stream::of_trial(305, trial);
    // The whole 2^31 steps between the ends of the guard band.
    let mut far = || (stream.bits() >> 1) as i32 - (1 << 30);
    let corners = std::array::from_fn(|_| Fixed { x: far(), y: far() });
    let mut near = || far().rem_euclid(1 << 19);
    Wide { corners, sample: Fixed { x: near(), y: near() } }
}

/// RA-05, naive.
pub(super) fn narrow_edges_fail(trial: u64) -> bool {
    let Wide { corners, sample } = wide(trial);
    narrow_covers(corners, sample) != wide_covers(corners, sample)
}

/// RA-05, robust.
pub(super) fn wide_edges_fail(trial: u64) -> bool {
    let Wide { corners, sample } = wide(trial);
    let covered = edges(corners).is_some_and(|edges| covers(&edges, sample));
    covered != wide_covers(corners, sample)
}
