//! The structures against one another.

use common::cost::{Experiment, Method, Plot, no_note};
use glam::Vec3;

use super::sight::{ERROR, Sight};
use crate::accelerator::Accelerator;
use crate::bsp::BspTree;
use crate::grid::Grid;
use crate::kd::{KdTree, Split};
use crate::octree::Octree;
use crate::scan::Scan;

/// All structures on the bunny.
pub(super) fn bunny(triangles: Vec<[Vec3; 3]>) -> Experiment<'static> {
    Experiment {
        name: "bunny",
        title: "The bunny by each structure",
        work_unit: "rays",
        error_metric: ERROR,
        plot: Plot::ErrorOverTime("wrong hits"),
        methods: methods(&Sight::bunny(triangles), str::to_owned),
        note: no_note,
    }
}

/// All structures, and more and more triangles.
pub(super) fn growth() -> Experiment<'static> {
    let of =
        |count: u32| methods(&Sight::sphere(count), |name| format!("{name}, {count} triangles"));
    Experiment {
        name: "growth",
        title: "Spheres of more and more triangles by each structure",
        work_unit: "rays",
        error_metric: ERROR,
        plot: Plot::TimeOver("triangles"),
        methods: [200, 2_000, 20_000].into_iter().flat_map(of).collect(),
        note: no_note,
    }
}

fn methods(sight: &Sight, label: impl Fn(&str) -> String) -> Vec<Method<'static>> {
    let triangles = || sight.triangles.clone();
    vec![
        method(sight, Scan::build(triangles()), "linear scan", &label),
        method(sight, Grid::build(triangles()), "grid", &label),
        method(sight, Octree::build(triangles()), "octree", &label),
        method(
            sight,
            KdTree::with_split(&sight.triangles, Split::Median),
            "k-d tree (median)",
            &label,
        ),
        method(sight, KdTree::build(triangles()), "k-d tree (SAH)", &label),
        method(sight, BspTree::build(triangles()), "BSP tree", &label),
    ]
}

fn method(
    sight: &Sight,
    accelerator: impl Accelerator + 'static,
    name: &'static str,
    label: &impl Fn(&str) -> String,
) -> Method<'static> {
    let size = sight.triangles.len() as f64;
    sight.method(accelerator, name, label(name), size, sight.rays())
}
