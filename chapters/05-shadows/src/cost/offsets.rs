//! The cures: self-hits and leaks against nanoseconds.

use std::hint::black_box;
use std::sync::Arc;

use common::cost::{Experiment, Method, Plot, Table};
use glam::Vec3;

use crate::hard::grid::Spot;
use crate::naive;
use crate::offset::Leave;
use crate::spawn::spawn;

/// Spawns for counting failures.
const COUNTED: u64 = 100_000;
/// Spawns for measuring time, and how often a run does them.
const TIMED: usize = 512;
const REPEATS: usize = 1600;

pub(super) fn experiment() -> Experiment<'static> {
    let spots: Arc<Vec<Spot>> = Arc::new((0..COUNTED).map(Spot::new).collect());
    Experiment {
        name: "offsets",
        title: "Where a ray starts: triangles 10^-4 to 10^4 large, up to 10^6 from the origin",
        work_unit: "spawns",
        error_metric: "self-hits and leaks per million spawns, known by construction",
        plot: Plot::ErrorOverTime("self-hits and leaks per million"),
        methods: vec![
            method("none", &spots, naive::stay, naive::stay),
            method("fixed, along the ray", &spots, naive::fixed, naive::fixed),
            method("fixed, along the normal", &spots, naive::normal, naive::normal),
            method("integer", &spots, naive::integer, naive::integer),
            method("error bound", &spots, spawn, spawn),
        ],
        note,
    }
}

/// `leave` for counting, and the same as `inlined` for time: a call by pointer would cost more than
/// some of the formulas.
fn method(
    label: &'static str,
    spots: &Arc<Vec<Spot>>,
    leave: Leave,
    inlined: impl Fn(&ray_casting::shape::Hit, Vec3) -> Vec3 + 'static,
) -> Method<'static> {
    let failures =
        spots.iter().map(|spot| u64::from(spot.hits_itself(leave)) + u64::from(spot.leaks(leave)));
    let error = 1e6 * failures.sum::<u64>() as f64 / COUNTED as f64;
    let spots = spots.clone();
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: (TIMED * REPEATS) as u64,
        error,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                let sum: Vec3 = black_box(&spots[..TIMED])
                    .iter()
                    .map(|spot| inlined(spot.hit(), spot.direction()))
                    .sum();
                black_box(sum);
            }
        }),
    }
}

fn note(table: &Table) -> String {
    let row = |label: &str| table.rows.iter().find(|row| row.label == label);
    match (row("error bound"), row("fixed, along the normal")) {
        (Some(bound), Some(fixed)) => format!(
            "The offset by the error bound takes {:.1} ns, that by a fixed step {:.1} ns.",
            bound.nanoseconds(),
            fixed.nanoseconds()
        ),
        _ => String::new(),
    }
}
