//! What a depth cuts off, and what the roulette does instead.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, no_note};
use common::film::Film;
use common::tally::{Counts, Off};
use path_tracing::tracer::LONGEST_PATH;

use super::sight::{How, Sight};
use crate::ending::Rule;
use crate::roulette::Roulette;

/// All pictures share their random numbers: they differ by what they cut off.
const WHOLE: How = How { rule: Rule::Never, depth: 100, spp: 256, seed: 1401 };

pub(super) fn experiment() -> Option<Experiment<'static>> {
    let sight = Rc::new(Sight::new()?);
    let whole = light(&sight.draw::<Off>(WHOLE).0);
    let depths = [1, 2, 4, 8, 16]
        .map(|depth| method(&sight, whole, format!("depth {depth}"), How { depth, ..WHOLE }));
    let rule = Rule::Throughput(Roulette::default());
    let roulette = method(&sight, whole, "roulette".into(), How { rule, ..WHOLE });
    Some(Experiment {
        name: "depth",
        title: "The Cornell box, 24x24, 256 samples: the light that is missing",
        work_unit: "pictures",
        error_metric: "relative difference of all light from that at depth 100, same random numbers",
        plot: Plot::ErrorOverTime("light that is missing, or noise"),
        methods: depths.into_iter().chain([roulette]).collect(),
        note: no_note,
    })
}

/// The picture's light: the mean of the three colours over all pixels.
fn light(film: &Film) -> f64 {
    let sum: f64 = film.pixels.iter().map(|pixel| pixel.as_dvec3().element_sum()).sum();
    sum / film.pixels.len() as f64 / 3.0
}

fn method(sight: &Rc<Sight>, whole: f64, label: String, how: How) -> Method<'static> {
    let (film, tally) = sight.draw::<Counts>(how);
    let sight = Rc::clone(sight);
    Method {
        label,
        series: "depth",
        size: tally.of(LONGEST_PATH) as f64,
        work: 1,
        error: (light(&film) / whole - 1.0).abs(),
        run: Box::new(move || drop(black_box(sight.draw::<Off>(how)))),
    }
}
