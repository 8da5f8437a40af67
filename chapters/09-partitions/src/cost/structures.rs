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
        plot: Plot::TimeOver("triangle tests, cells and nodes for each ray"),
        methods: methods(&Sight::bunny(triangles), str::to_owned, |sight, work| {
            work as f64 / sight.rays() as f64
        }),
        note: no_note,
    }
}

/// All structures, and more and more triangles.
pub(super) fn growth() -> Experiment<'static> {
    let of = |count: u32| {
        let label = |name: &str| format!("{name}, {count} triangles");
        methods(&Sight::sphere(count), label, |sight, _| sight.triangles.len() as f64)
    };
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

/// All structures, each at its place on the plot's axis, which may depend on its work.
fn methods(
    sight: &Sight,
    label: impl Fn(&str) -> String,
    place: impl Fn(&Sight, u64) -> f64,
) -> Vec<Method<'static>> {
    let triangles = || sight.triangles.clone();
    let median = KdTree::with_split(&sight.triangles, Split::Median);
    let naming = Naming { sight, label, place };
    vec![
        naming.method("linear scan", Scan::build(triangles())),
        naming.method("grid", Grid::build(triangles())),
        naming.method("octree", Octree::build(triangles())),
        naming.method("k-d tree (median)", median),
        naming.method("k-d tree (SAH)", KdTree::build(triangles())),
        naming.method("BSP tree", BspTree::build(triangles())),
    ]
}

/// How the methods over one scene are called and placed.
struct Naming<'a, Label, Place> {
    sight: &'a Sight,
    label: Label,
    place: Place,
}

impl<Label: Fn(&str) -> String, Place: Fn(&Sight, u64) -> f64> Naming<'_, Label, Place> {
    fn method(
        &self,
        name: &'static str,
        accelerator: impl Accelerator + 'static,
    ) -> Method<'static> {
        let size = (self.place)(self.sight, self.sight.work(&accelerator));
        self.sight.method(accelerator, name, (self.label)(name), size, self.sight.rays())
    }
}
