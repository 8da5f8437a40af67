//! MF-08: the densities are densities, in lobes of any width.

use common::hard::Case;
use glam::Vec3;

use super::{CHAPTER, at};
use crate::ggx::Ggx;

const ROUGHNESSES: [f32; 7] = [1.0, 0.5, 0.2, 0.05, 0.01, 3e-3, 1e-3];
const HEIGHTS: [f32; 4] = [1.0, 0.5, 0.1, 0.01];
const STEPS: u32 = 400;

/// MF-08: Σ over a grid of angles has no node inside of a narrow lobe.
pub(super) const ONE: Case = Case {
    id: "MF-08",
    chapter: CHAPTER,
    input: "the integral of the density of visible normals, by a grid",
    most: (ROUGHNESSES.len() * HEIGHTS.len()) as u64,
    naive_fails: |trial| !((by_angles(trial) - 1.0).abs() <= 2e-3),
    robust_fails: |trial| !((by_lobe(trial) - 1.0).abs() <= 2e-3),
};

fn setting(trial: u64) -> (Ggx, Vec3) {
    let (row, column) = (trial as usize / HEIGHTS.len(), trial as usize % HEIGHTS.len());
    (Ggx { alpha: ROUGHNESSES[row] }, at(HEIGHTS[column], 0.7))
}

fn cells() -> impl Iterator<Item = (f32, f32)> {
    let middle = |step: u32| (step as f32 + 0.5) / STEPS as f32;
    (0..STEPS).flat_map(move |i| (0..STEPS).map(move |j| (middle(i), middle(j))))
}

/// Nodes at equal steps of both angles.
fn by_angles(trial: u64) -> f64 {
    let (ggx, view) = setting(trial);
    let quarter = std::f32::consts::FRAC_PI_2;
    let area = std::f64::consts::TAU * f64::from(quarter) / f64::from(STEPS * STEPS);
    let sum: f64 = cells()
        .map(|(u, v)| {
            let normal = at(common::math::cos(quarter * u), std::f32::consts::TAU * v);
            let sine = common::math::sin(quarter * u);
            f64::from(ggx.visible_density(view, normal) * sine)
        })
        .sum();
    sum * area
}

/// Nodes at equal steps in coordinates that follow the lobe: u² of all facets are steeper than those
/// at u. The square, for few steep ones make much of what is seen from the side.
fn by_lobe(trial: u64) -> f64 {
    let (ggx, view) = setting(trial);
    let sum: f64 = cells()
        .map(|(u, v)| {
            let radius = ggx.alpha * ((1.0 - u) * (1.0 + u)).sqrt() / u;
            let turn = std::f32::consts::TAU * v;
            let (x, y) = (common::math::cos(turn), common::math::sin(turn));
            let normal = Vec3::new(radius * x, radius * y, 1.0).normalize();
            let all = ggx.density(normal) * normal.z;
            f64::from(2.0 * u * ggx.visible_density(view, normal) / all)
        })
        .sum();
    sum / f64::from(STEPS * STEPS)
}
