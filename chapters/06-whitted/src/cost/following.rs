//! Ways to follow a ray from mirror to mirror: the same light, another place for what is left to do.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, Table};
use common::film::Color;
use common::tally::Off;

use crate::facing::{Facing, series};
use crate::limits::Limits;
use crate::naive::{radiance, trace_in_single};

/// Mirrors a ray meets: as many as the recursion can.
const DEPTH: u32 = 500;
/// Rays in one run.
const RAYS: u64 = 400;

const MIRRORS: Facing = Facing { light: 0.3, mirror: 0.999 };
const LIMITS: Limits = Limits { depth: DEPTH, cutoff: 0.0 };

pub(super) fn experiment() -> Experiment<'static> {
    Experiment {
        name: "following",
        title: "500 mirrors in a row, without geometry: ways to follow them",
        work_unit: "mirrors",
        error_metric: "relative error of the radiance against the geometric series",
        plot: Plot::ErrorOverTime("error of the radiance (relative)"),
        methods: vec![
            method("textbook recursion, f32", |ray| radiance(&MIRRORS, &ray, DEPTH, &mut Off)),
            method("loop, f32", |ray| trace_in_single(&MIRRORS, ray, DEPTH, &mut Off)),
            method("recursion, f64 sums", |ray| LIMITS.trace_by_recursion(&MIRRORS, ray, &mut Off)),
            method("loop, f64 sums", |ray| LIMITS.trace(&MIRRORS, ray, &mut Off)),
        ],
        note: |table: &Table| {
            let [_, _, recursion, looped] = &table.rows[..] else { return String::new() };
            let ratio = recursion.nanoseconds() / looped.nanoseconds();
            format!("The recursion takes {ratio:.2} times the time of the loop, for the same bits.")
        },
    }
}

fn method(label: &'static str, follow: fn(u64) -> Color) -> Method<'static> {
    let exact = f64::from(MIRRORS.light) * series(f64::from(MIRRORS.mirror), DEPTH);
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: RAYS * u64::from(DEPTH),
        error: (f64::from(follow(0).x) - exact).abs() / exact,
        run: Box::new(move || {
            for ray in 0..RAYS {
                black_box(follow(black_box(ray)));
            }
        }),
    }
}
