//! What the report's traversal wastes (erratum 7), and what a better layout saves.

use common::cost::{Experiment, Method, Plot, Table};
use glam::Vec3;
use partitions::accelerator::Accelerator;
use partitions::cost::sight::{ERROR, Sight};
use partitions::scan::Scan;

use crate::packed::PackedBvh;
use crate::plain::{BothChildren, NearChildFirst};

const BOTH: &str = "both children";
const ORDERED: &str = "nearer child first";
const PACKED: &str = "two boxes, four triangles at once";

/// The same tree, walked in three ways; and no tree.
pub(super) fn experiment(corners: &[[Vec3; 3]]) -> Experiment<'static> {
    let sight = Sight::bunny(corners.to_vec());
    Experiment {
        name: "traversals",
        title: "The bunny's tree, walked in three ways",
        work_unit: "nodes and triangles asked",
        error_metric: ERROR,
        plot: Plot::ErrorOverTime("wrong hits"),
        methods: vec![
            method(&sight, Scan::build(corners.to_vec()), "no tree"),
            method(&sight, BothChildren::build(corners.to_vec()), BOTH),
            method(&sight, NearChildFirst::build(corners.to_vec()), ORDERED),
            method(&sight, PackedBvh::build(corners.to_vec()), PACKED),
        ],
        note,
    }
}

fn method(
    sight: &Sight,
    accelerator: impl Accelerator + 'static,
    name: &'static str,
) -> Method<'static> {
    let work = sight.work(&accelerator);
    sight.method(accelerator, name, name.into(), 1.0, work)
}

fn note(table: &Table) -> String {
    let row = |label: &str| table.rows.iter().find(|row| row.label == label);
    let (Some(both), Some(ordered), Some(packed)) = (row(BOTH), row(ORDERED), row(PACKED)) else {
        return String::new();
    };
    let work = both.work as f64 / ordered.work as f64;
    let [before, after] = [both, ordered].map(|row| row.time.median / packed.time.median);
    format!(
        "The report's way asks {work:.1} times as much as the nearer child first. With two boxes and \
         four triangles at once that takes {before:.1} times less time than the report's way, and \
         {after:.1} times less than the nearer child first, node by node."
    )
}
