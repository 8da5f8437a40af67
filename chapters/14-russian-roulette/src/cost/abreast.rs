//! What sixteen paths side by side save.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, Table};
use common::film::Film;
use common::stats::error::film_rmse;
use common::tally::Off;

use super::sight::{How, Sight};
use crate::abreast::Start;
use crate::ending::Rule;
use crate::roulette::Roulette;

/// How the picture is made.
const HOW: How =
    How { rule: Rule::Throughput(Roulette { threshold: 0.5 }), depth: 1000, spp: 64, seed: 1 };

fn single(sight: &Sight) -> Film {
    sight.draw::<Off>(HOW).0
}

fn together(sight: &Sight) -> Film {
    sight.draw_abreast(HOW, Start::Together)
}

fn at_once(sight: &Sight) -> Film {
    sight.draw_abreast(HOW, Start::AtOnce)
}

/// The same picture three times.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let sight = Rc::new(Sight::new()?);
    let truth = single(&sight);
    let method = |label: &'static str, draw: fn(&Sight) -> Film| {
        let error = film_rmse(&truth, &draw(&sight)).unwrap_or(f64::NAN);
        let (sight, work) = (Rc::clone(&sight), truth.pixels.len() as u64 * u64::from(HOW.spp));
        let run = Box::new(move || drop(black_box(draw(&sight))));
        Method { label: label.into(), series: label, size: 1.0, work, error, run }
    };
    Some(Experiment {
        name: "abreast",
        title: "The Cornell box, 24x24, 64 samples, one thread: paths one by one and side by side",
        work_unit: "paths",
        error_metric: "RMS difference from the picture by one path after another",
        plot: Plot::ErrorOverTime("difference (RMS)"),
        methods: vec![
            method("one by one", single),
            method("sixteen, all wait for the longest", together),
            method("sixteen, a path that ends makes room", at_once),
        ],
        note,
    })
}

fn note(table: &Table) -> String {
    let [single, together, at_once] = &table.rows[..] else { return String::new() };
    format!(
        "Side by side is {:.1} times as fast as one by one, and {:.1} times as fast if all wait for the \
         longest path.",
        single.nanoseconds() / at_once.nanoseconds(),
        single.nanoseconds() / together.nanoseconds()
    )
}
