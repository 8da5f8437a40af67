//! What it takes to build each structure.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, no_note};
use glam::Vec3;
use triangles::bumpy;

use crate::accelerator::{Accelerator, Statistics};
use crate::bsp::BspTree;
use crate::grid::Grid;
use crate::kd::{KdTree, Split};
use crate::octree::Octree;

type Triangles = Vec<[Vec3; 3]>;

/// Building, for more and more triangles.
pub(super) fn experiment() -> Experiment<'static> {
    Experiment {
        name: "build",
        title: "Building each structure over spheres",
        work_unit: "triangles stored",
        error_metric: "share of the triangles that are not stored",
        plot: Plot::TimeOver("triangles"),
        methods: [200, 2_000, 20_000].into_iter().flat_map(methods).collect(),
        note: no_note,
    }
}

fn methods(count: u32) -> Vec<Method<'static>> {
    let triangles = bumpy::sphere(count).all_corners();
    let median = |triangles: Triangles| KdTree::with_split(&triangles, Split::Median);
    vec![
        method(&triangles, "grid", Grid::build),
        method(&triangles, "octree", Octree::build),
        method(&triangles, "k-d tree (median)", median),
        method(&triangles, "k-d tree (SAH)", KdTree::build),
        method(&triangles, "BSP tree", BspTree::build),
    ]
}

fn method<A: Accelerator + 'static>(
    triangles: &Triangles,
    name: &'static str,
    build: impl Fn(Triangles) -> A + 'static,
) -> Method<'static> {
    let triangles = triangles.clone();
    let count = triangles.len();
    let Statistics { references, left_out, .. } = build(triangles.clone()).statistics();
    Method {
        label: format!("{name}, {count} triangles"),
        series: name,
        size: count as f64,
        work: references as u64,
        error: left_out as f64 / count as f64,
        run: Box::new(move || drop(black_box(build(triangles.clone())))),
    }
}
