//! The middle of the Cornell box by paths that neighbouring pixels share: error against time.

use std::rc::Rc;

use common::cost::{Experiment, Plot, no_note};

use super::sight::{How, Look, Sight};
use crate::heuristic::Heuristic;
use crate::scenes::named;

/// The scene: a quarter of its width and height, so that pixels lie as close together as in a picture of
/// a usual size.
fn sight() -> Option<Rc<Sight>> {
    let mut model = named("cornell", 0.5).ok()?;
    model.view.vertical_fov = 10.0;
    Sight::new(&model, SIZE, 1000, 1024)
}

/// A multiple of the largest square.
const SIZE: [u32; 2] = [40, 40];

/// Sides of squares, and samples of a pixel that take about the same time.
const STEPS: [(&str, u32, [u32; 3]); 4] = [
    ("alone", 1, [4, 16, 64]),
    ("2x2 pixels", 2, [3, 12, 48]),
    ("4x4 pixels", 4, [2, 6, 24]),
    ("8x8 pixels", 8, [1, 3, 9]),
];

/// The error over time, for squares of several sizes.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let sight = sight()?;
    let lighting = Look::Combined(Heuristic::Power);
    let mut methods = Vec::new();
    for (series, side, samples) in STEPS {
        methods.extend(samples.map(|spp| {
            let how = How { lighting, roulette: true, side, spp, seed: 1 };
            sight.method(series, format!("{series}, {spp} spp"), how)
        }));
    }
    Some(Experiment {
        name: "neighbours",
        title: "The middle of the Cornell box, 40x40, by paths that squares of pixels share",
        work_unit: "paths",
        error_metric: "relative RMSE against 2048 spp of pixels alone, itself off by less than 0.02",
        plot: Plot::Convergence("relative error (RMSE)"),
        methods,
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
