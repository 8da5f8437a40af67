//! Time against triangles, for every structure of this part.

use common::cost::{Experiment, Method, Plot, Table};
use common::math::log10;
use partitions::accelerator::Accelerator;
use partitions::bsp::BspTree;
use partitions::cost::sight::{ERROR, Sight};
use partitions::grid::Grid;
use partitions::kd::KdTree;
use partitions::octree::Octree;
use partitions::scan::Scan;

use crate::packed::PackedBvh;

const BVH: &str = "BVH";

/// Sizes, and of how many rays one can be checked by the scan.
const SIZES: [(u32, usize); 5] =
    [(100, 1), (1_000, 1), (10_000, 4), (100_000, 40), (1_000_000, 400)];

/// Structures drop out where building them would take longer than the book can wait.
pub(super) fn experiment() -> Experiment<'static> {
    let of = |(size, step): (u32, usize)| {
        let sight = Sight::large_sphere(size, step);
        let mut methods = vec![method::<PackedBvh>(&sight, BVH)];
        if size <= 100_000 {
            methods.push(method::<Grid>(&sight, "grid"));
            methods.push(method::<Octree>(&sight, "octree"));
        }
        if size <= 10_000 {
            methods.push(method::<KdTree>(&sight, "k-d tree"));
            methods.push(method::<BspTree>(&sight, "BSP tree"));
            methods.push(method::<Scan>(&sight, "linear scan"));
        }
        methods
    };
    Experiment {
        name: "growth",
        title: "The same picture of more and more triangles",
        work_unit: "rays",
        error_metric: ERROR,
        plot: Plot::TimeOver("triangles"),
        methods: SIZES.into_iter().flat_map(of).collect(),
        note,
    }
}

fn method<A: Accelerator + 'static>(sight: &Sight, name: &'static str) -> Method<'static> {
    let count = sight.triangles.len();
    let label = format!("{name}, {count} triangles");
    let accelerator = A::build(sight.triangles.clone());
    sight.method(accelerator, name, label, count as f64, sight.rays())
}

/// How fast the time for a ray grows from the second size to the last.
fn note(table: &Table) -> String {
    let time = |size: u32| {
        let row = table.rows.iter().find(|row| row.series == BVH && row.size == f64::from(size));
        row.map(|row| row.nanoseconds())
    };
    let (small, large) = (SIZES[1].0, SIZES[SIZES.len() - 1].0);
    let (Some(few), Some(many)) = (time(small), time(large)) else { return String::new() };
    let [small, large, times] = [f64::from(small), f64::from(large), many / few].map(log10);
    let (logarithms, slope) = (large / small, times / (large - small));
    format!(
        "From 10^3 to 10^6 triangles the logarithm grows {logarithms:.1} times, and the time for a \
         ray through the BVH {:.1} times: a slope of {slope:.2} on these axes.",
        many / few
    )
}
