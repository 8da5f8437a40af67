//! What each step of Part IV brought to the Cornell box.

use std::rc::Rc;

use common::cost::{Experiment, Plot, no_note};

use super::sight::{How, Look, Sight};
use crate::heuristic::Heuristic;
use crate::scenes::named;

/// The scene.
fn sight() -> Option<Rc<Sight>> {
    Sight::new(&named("cornell", 0.5).ok()?, [24, 24], 8, 512)
}

/// The steps, each with what came before.
const STEPS: [(&str, Look, bool); 5] = [
    ("12 by direction", Look::Direction, false),
    ("13 by area", Look::Area, false),
    ("13 by solid angle", Look::Light, false),
    ("14 with roulette", Look::Light, true),
    ("16 combined", Look::Combined(Heuristic::Power), true),
];

/// The box of chapter 12, as each chapter draws it.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let sight = sight()?;
    let method = |(label, lighting, roulette): (&'static str, Look, bool)| {
        sight.method(label, label.into(), How { lighting, roulette, side: 1, spp: 16, seed: 1 })
    };
    Some(Experiment {
        name: "part-four",
        title: "The Cornell box, 24x24, 16 samples of a pixel: what each chapter brought",
        work_unit: "paths",
        error_metric: "relative RMSE against 1024 spp of both ways, itself off by less than 0.02",
        plot: Plot::ErrorOverTime("relative error (RMSE)"),
        methods: STEPS.into_iter().map(method).collect(),
        note: no_note,
    })
}

#[cfg(test)]
mod tests {
    use super::sight;
    use crate::cost::sight::assert_converged;

    #[test]
    fn what_all_is_held_against_is_as_good_as_it_says() {
        assert_converged(&sight().expect("a scene"), 0.02);
    }
}
