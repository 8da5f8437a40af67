//! The plates: four ways to look for light, and how their errors fall.

use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, no_note};

use super::sight::{How, Look, Sight};
use crate::heuristic::Heuristic;
use crate::plates::Plates;

const LOOKS: [(&str, Look); 4] = [
    ("light", Look::Light),
    ("direction", Look::Direction),
    ("balance", Look::Combined(Heuristic::Balance)),
    ("power", Look::Combined(Heuristic::Power)),
];

/// Samples of each of the two pictures that everything is held against.
const CONVERGED: u32 = 1024;

const SIZE: [u32; 2] = [64, 32];

/// The scene.
fn sight() -> Option<Rc<Sight>> {
    Sight::new(&Plates::VEACH.close_up(), SIZE, 2, CONVERGED)
}

/// The error over the time, for more and more samples of a pixel.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let sight = sight()?;
    let of = |spp: u32| {
        LOOKS.map(|(series, lighting)| {
            let how = How { lighting, roulette: false, side: 1, spp, seed: 1 };
            sight.method(series, format!("{series}, {spp} spp"), how)
        })
    };
    let methods: Vec<Method> = [1, 4, 16, 64].into_iter().flat_map(of).collect();
    Some(Experiment {
        name: "plates",
        title: "Veach's plates, but for pixels that show a lamp, 64x32, to a depth of 2",
        work_unit: "paths",
        error_metric: "relative RMSE against 2048 spp of both ways, itself off by less than 0.05",
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
        assert_converged(&sight().expect("a scene"), 0.05);
    }
}
