//! One path, or a tree of them, for the same number of rays.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, Row, Table};
use common::sampler::Sampler;
use common::tally::{Counts, Off, Tally};
use glam::Vec3;
use ray_casting::camera::CAMERA_RAYS;
use ray_casting::ray::Ray;

use crate::branching::{Branching, rays};
use crate::furnace;
use crate::smooth::Smooth;
use crate::stage::Stage;
use crate::tracer::BOUNCES;

const ALBEDO: f32 = 0.8;
const DEPTH: u32 = 6;

/// How many estimates the error is taken over. Its own error is an eighth.
const ESTIMATES: u64 = 32;

const RAY: Ray = Ray { origin: Vec3::new(1.5, 0.25, -0.125), direction: Vec3::X };

const ONE: &str = "1 direction";
const TWO: &str = "2 directions";
const FOUR: &str = "4 directions";

/// The wall of a shell around a lamp, whose radiance is known.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let stage = Rc::new(Stage::new(&furnace::shell(ALBEDO)).ok()?);
    let methods = [(ONE, 1), (TWO, 2), (FOUR, 4)].into_iter().flat_map(|(series, directions)| {
        let stage = Rc::clone(&stage);
        [1 << 12, 1 << 14, 1 << 16].map(|budget| method(&stage, series, directions, budget))
    });
    Some(Experiment {
        name: "branching",
        title: "A lamp in a shell of albedo 0.8, depth 6: how many directions from each surface",
        work_unit: "rays",
        error_metric: "RMS error of 32 estimates against the closed form",
        plot: Plot::ErrorOver { size: "rays", error: "error (RMS)" },
        methods: methods.collect(),
        note,
    })
}

/// The mean of as many trees as have about `budget` rays.
fn method(
    stage: &Rc<Stage<Smooth>>,
    series: &'static str,
    directions: u32,
    budget: u64,
) -> Method<'static> {
    // Three rays of four meet the wall again and go on.
    let met_wall = |level: u32| (1..level).fold(1.0, |rest, _| 0.75 * rest);
    let level = |depth: u32| (rays(directions, depth) - rays(directions, depth - 1)) as f64;
    let expected: f64 = (1..=DEPTH).map(|depth| level(depth) * met_wall(depth)).sum();
    let trees = (budget as f64 / (1.0 + expected)).round().max(1.0) as u64;

    let right = furnace::shell_radiance(f64::from(ALBEDO), DEPTH);
    let mut counts = Counts::default();
    let square = |estimate| {
        let error = mean(stage, directions, trees, estimate, &mut counts) - right;
        error * error
    };
    let error = ((0..ESTIMATES).map(square).sum::<f64>() / ESTIMATES as f64).sqrt();
    let work = (counts.of(BOUNCES) + counts.of(CAMERA_RAYS)) / ESTIMATES;
    let stage = Rc::clone(stage);
    Method {
        label: format!("{series}, about {budget} rays"),
        series,
        size: work as f64,
        work,
        error,
        run: Box::new(move || {
            black_box(mean(&stage, directions, trees, 0, &mut Off));
        }),
    }
}

/// The mean of `trees` trees. Each is a trial of its own: no method gains from points that are
/// spread evenly.
fn mean<T: Tally>(
    stage: &Stage<Smooth>,
    directions: u32,
    trees: u64,
    estimate: u64,
    tally: &mut T,
) -> f64 {
    let world = stage.world();
    let branching = Branching { world: &world, directions, depth: DEPTH };
    let mut sum = 0.0;
    for tree in 0..trees {
        tally.count(CAMERA_RAYS, 1);
        let sampler = Sampler::new(1201 + estimate, tree, 0, 1);
        sum += f64::from(branching.radiance(black_box(RAY), &sampler, tally).y);
    }
    sum / trees as f64
}

/// How much more time the same error takes.
fn note(table: &Table) -> String {
    let last = |series| table.rows.iter().rfind(|row| row.series == series);
    let (Some(one), Some(two), Some(four)) = (last(ONE), last(TWO), last(FOUR)) else {
        return String::new();
    };
    let more = |row: &Row| {
        let squares = (row.error / one.error) * (row.error / one.error);
        squares * row.size / one.size
    };
    format!(
        "By the last row of each, the error of one path takes {:.1} times as many rays with 2 \
         directions, and {:.1} times as many with 4.",
        more(two),
        more(four)
    )
}
