//! Time against the number of cells in a grid.

use common::cost::{Experiment, Method, Plot, Row, Table};
use glam::Vec3;

use super::sight::{ERROR, Sight};
use crate::accelerator::Accelerator;
use crate::grid::Grid;

const BUNNY: &str = "bunny";
const SPHERE: &str = "sphere:20000";

/// Grids from one cell to very many, and the number that the heuristic takes.
pub(super) fn experiment(bunny: &[[Vec3; 3]]) -> Experiment<'static> {
    let bunny = methods(&Sight::bunny(bunny.to_vec()), BUNNY);
    let sphere = methods(&Sight::sphere(20_000), SPHERE);
    Experiment {
        name: "cells",
        title: "A grid of more and more cells",
        work_unit: "tests and cells",
        error_metric: ERROR,
        plot: Plot::TimeOver("cells along the longest side"),
        methods: bunny.into_iter().chain(sphere).collect(),
        note,
    }
}

fn methods(sight: &Sight, name: &'static str) -> Vec<Method<'static>> {
    let chosen = longest_side(&Grid::build(sight.triangles.clone()));
    let mut sides = vec![2, 4, 8, 16, 24, 32, 48, 64, 128, 256];
    sides.push(chosen);
    sides.sort_unstable();
    sides.dedup();
    let method = |side: u32| {
        let grid = Grid::with_cells(&sight.triangles, side);
        let mark = if side == chosen { CHOSEN } else { "" };
        let work = sight.work(&grid);
        sight.method(
            grid,
            name,
            format!("{name}, {side} cells a side{mark}"),
            f64::from(side),
            work,
        )
    };
    sides.into_iter().map(method).collect()
}

fn longest_side(grid: &Grid) -> u32 {
    let longest = grid.cells().into_iter().max();
    longest.unwrap_or(1) as u32
}

const CHOSEN: &str = " (by the heuristic)";

/// How much slower than the best the heuristic's number of cells is.
fn note(table: &Table) -> String {
    let sentence = |name: &str| {
        let rows = || table.rows.iter().filter(move |row| row.series == name);
        let chosen = rows().find(|row| row.label.ends_with(CHOSEN))?;
        let best = rows().min_by(|one, other| time(one).total_cmp(&time(other)))?;
        let ratio = time(chosen) / time(best);
        Some(format!(
            "{name}: the heuristic takes {} cells a side; {} would be best, and the heuristic takes \
             {ratio:.2} times as long.",
            chosen.size, best.size
        ))
    };
    [BUNNY, SPHERE].into_iter().filter_map(sentence).collect::<Vec<_>>().join(" ")
}

fn time(row: &Row) -> f64 {
    row.time.median
}
