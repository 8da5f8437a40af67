//! How often paths should go on.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, Row, Table};
use common::film::Film;
use common::stats::error::film_relative_mse;
use common::tally::{Counts, Off};
use path_tracing::tracer::BOUNCES;

use super::sight::{How, Sight};
use crate::ending::Rule;
use crate::roulette::{Constant, Roulette};

/// Pictures over which the error is averaged, and their samples.
const PICTURES: u64 = 4;
const SPP: u32 = 32;

/// What the pictures are held against: of its own noise there is an eighth as much.
const CONVERGED: How =
    How { rule: Rule::Throughput(Roulette { threshold: 0.5 }), depth: 1000, spp: 2048, seed: 1400 };

const THROUGHPUT: &str = "by throughput";
const CONSTANT: &str = "constant";

pub(super) fn experiment() -> Option<Experiment<'static>> {
    let sight = Rc::new(Sight::new()?);
    let truth = sight.draw::<Off>(CONVERGED).0;
    let constants = [0.2, 0.4, 0.6, 0.8, 1.0].into_iter().filter_map(|survival| {
        let rule = Rule::Constant(Constant::new(survival)?);
        Some(method(&sight, &truth, CONSTANT, format!("survival {survival}"), rule))
    });
    let thresholds = [0.25, 0.5, 1.0, 2.0].map(|threshold| {
        let rule = Rule::Throughput(Roulette { threshold });
        method(&sight, &truth, THROUGHPUT, format!("threshold {threshold}"), rule)
    });
    Some(Experiment {
        name: "survival",
        title: "The Cornell box, 24x24, 32 samples: how often paths go on",
        work_unit: "pictures",
        error_metric: "relative RMSE of four pictures against one of 2048 samples",
        plot: Plot::ErrorOverTime("relative error of the picture (RMSE)"),
        methods: constants.chain(thresholds).collect(),
        note,
    })
}

fn method(
    sight: &Rc<Sight>,
    truth: &Film,
    series: &'static str,
    label: String,
    rule: Rule,
) -> Method<'static> {
    let how = move |seed| How { rule, depth: 1000, spp: SPP, seed };
    let (mut squares, mut bounces) = (0.0, 0);
    for seed in 0..PICTURES {
        let (film, tally) = sight.draw::<Counts>(how(seed));
        squares += film_relative_mse(truth, &film).unwrap_or(f64::NAN);
        bounces += tally.of(BOUNCES);
    }
    let sight = Rc::clone(sight);
    Method {
        label,
        series,
        size: bounces as f64 / PICTURES as f64,
        work: 1,
        error: (squares / PICTURES as f64).sqrt(),
        run: Box::new(move || drop(black_box(sight.draw::<Off>(how(0))))),
    }
}

/// Variance times time: how much longer each takes for the same error.
fn note(table: &Table) -> String {
    let price = |row: &Row| row.error * row.error * row.nanoseconds();
    let best = |series: &str| {
        let rows = table.rows.iter().filter(|row| row.series == series);
        rows.min_by(|one, other| price(one).total_cmp(&price(other)))
    };
    let never = table.rows.iter().find(|row| row.label == "survival 1");
    let (Some(throughput), Some(constant), Some(never)) = (best(THROUGHPUT), best(CONSTANT), never)
    else {
        return String::new();
    };
    let ratio = |row: &Row| price(row) / price(throughput);
    format!(
        "For the same error, {} takes the least time. The best of the constants, {}, takes {:.2} \
         times as long, and paths that never end of themselves {:.2} times.",
        throughput.label,
        constant.label,
        ratio(constant),
        ratio(never)
    )
}
