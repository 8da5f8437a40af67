//! Light that is looked for in both ways: at lamps, and where the surface reflects it from.

use common::film::Color;
use common::tally::Tally;
use light_sampling::by_light::arriving;
use light_sampling::lights::Lights;
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;
use path_tracing::space::{Met, Space};
use path_tracing::strategy::Lighting;
use path_tracing::vertex::{Departure, Vertex};

use crate::heuristic::Heuristic;

// ANCHOR: combined
/// Light of lamps counts in part where it was looked for, and in part where a path came upon the
/// lamp: as much as the heuristic says.
#[derive(Clone, Copy, Debug)]
pub struct Combined<'a> {
    /// The lamps.
    pub lights: &'a Lights,
    /// How the two ways share.
    pub heuristic: Heuristic,
}

impl Lighting for Combined<'_> {
    #[inline]
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        let Some(sample) = self.lights.sample(vertex.hit().point, random) else {
            return Color::ZERO;
        };
        // The density with which the surface would have chosen the same direction.
        let incoming = vertex.frame.to_local(sample.point.direction);
        let by_direction = vertex.bsdf.pdf(vertex.outgoing, incoming);
        let share = self.heuristic.weight(sample.pdf, by_direction);
        arriving(space, vertex, &sample, tally) * (share / sample.pdf)
    }

    /// All of it where there was no density: from the eye, from mirrors and glass. Their flag says so;
    /// the number in `pdf` doesn't. All of it also where the lamp is never looked at: there the other
    /// density is 0.
    #[inline]
    fn share(&self, departure: &Departure, met: &Met) -> f32 {
        if departure.is_delta {
            return 1.0;
        }
        self.heuristic.weight(departure.pdf, self.lights.pdf(departure.from, met))
    }
}
// ANCHOR_END: combined

#[cfg(test)]
mod tests {
    use common::stats::running::Running;
    use light_sampling::by_light::ByLight;
    use light_sampling::lamp::Way;
    use light_sampling::lights::{Choice, Lights};
    use microfacets::finish::Finish;
    use path_tracing::stage::Stage;
    use path_tracing::strategy::ByDirection;

    use super::Combined;
    use crate::half::{Half, Side};
    use crate::heuristic::Heuristic;
    use crate::naive::{Added, Unchosen};
    use crate::plates::Plates;
    use crate::scenes::named;
    use crate::tiles::{Runs, least_p_value, stage, tiles};

    /// So often may right code be refused by one of these tests; the seeds are fixed.
    const SIGNIFICANCE: f64 = 0.01;
    const RUNS: Runs = Runs { width: 24, height: 16, spp: 16, count: 30, depth: 2, seed: 1 };
    /// Lamps and plates that either strategy alone finds often enough for a test.
    const BROAD: Plates = Plates { roughness: [0.4, 0.3, 0.2, 0.15], radii: [0.5, 0.6, 0.7, 0.9] };

    fn lights(stage: &Stage<Finish>) -> Lights {
        Lights::new(&stage.space, &stage.surfaces, Choice::Power, Way::SolidAngle)
    }

    fn combined(lights: &Lights, heuristic: Heuristic) -> Combined<'_> {
        Combined { lights, heuristic }
    }

    /// MI-06: four ways to look for light find the same.
    #[test]
    fn all_estimators_agree() {
        let stage = stage(&BROAD.close_up());
        let lights = lights(&stage);
        let more = Runs { spp: 64, seed: 2, ..RUNS };
        let found = [
            tiles(&stage, ByDirection, &more),
            tiles(&stage, ByLight { lights: &lights }, &Runs { seed: 3, ..more }),
            tiles(&stage, combined(&lights, Heuristic::Balance), &Runs { seed: 4, ..RUNS }),
            tiles(&stage, combined(&lights, Heuristic::Power), &Runs { seed: 5, ..RUNS }),
        ];
        for (index, one) in found.iter().enumerate() {
            for other in &found[..index] {
                let p_value = least_p_value(one, other);
                assert!(p_value > SIGNIFICANCE, "{index}: {p_value}");
            }
        }
    }

    /// The power of the test above: light that counts twice is found, and so are weights of another
    /// density, and 3 % more of everything.
    #[test]
    fn planted_errors_are_found() {
        let stage = stage(&BROAD.close_up());
        let lights = lights(&stage);
        let heuristic = Heuristic::Power;
        let right = tiles(&stage, combined(&lights, heuristic), &RUNS);
        let other = Runs { seed: 6, ..RUNS };
        let twice = tiles(&stage, Added(ByLight { lights: &lights }), &other);
        assert!(least_p_value(&right, &twice) < 1e-6);
        let unchosen = tiles(&stage, Unchosen { lights: &lights, heuristic }, &other);
        assert!(least_p_value(&right, &unchosen) < 1e-6);
        let again = tiles(&stage, combined(&lights, heuristic), &other);
        assert!(least_p_value(&right, &again) > SIGNIFICANCE);
        let more: Vec<Running> = again.iter().map(|tile| scaled(tile, 1.03)).collect();
        assert!(least_p_value(&right, &more) < 1e-6, "3 % more");
    }

    /// The same spread around another mean: enough for a test that looks at both.
    fn scaled(tile: &Running, factor: f64) -> Running {
        let deviation = tile.variance().unwrap_or(0.0).sqrt();
        let step = |index: u64| if index.is_multiple_of(2) { deviation } else { -deviation };
        (0..tile.count()).map(|index| factor * (tile.mean() + step(index))).collect()
    }

    /// MI-06: the spread of the combination is at most 1.2 times that of the better strategy, in each
    /// row of tiles of the chapter's own plates.
    #[test]
    fn the_combination_is_as_good_as_the_better_strategy() {
        let stage = stage(&Plates::VEACH.close_up());
        let lights = lights(&stage);
        let runs = Runs { count: 60, depth: 1, ..RUNS };
        let spread = |found: Vec<Running>| -> Vec<f64> {
            let variance = |tile: &Running| tile.variance().unwrap_or(0.0);
            let rows = found.chunks(runs.width as usize / 4);
            rows.map(|row| row.iter().map(variance).sum()).collect()
        };
        let by_light = spread(tiles(&stage, ByLight { lights: &lights }, &runs));
        let by_direction = spread(tiles(&stage, ByDirection, &runs));
        let power = spread(tiles(&stage, combined(&lights, Heuristic::Power), &runs));
        for ((light, direction), power) in by_light.iter().zip(&by_direction).zip(&power) {
            let least = light.min(*direction);
            assert!(*power <= 1.2 * least, "{power:.3e}: {light:.3e}, {direction:.3e}");
        }
    }

    /// Inside a cube that glows everything has the radiance 1 + a + a², for paths of two bounces.
    #[test]
    fn a_furnace_shows_nothing() {
        let stage = stage(&named("furnace", 0.5).expect("a scene"));
        let lights = lights(&stage);
        for heuristic in [Heuristic::Balance, Heuristic::Power] {
            for tile in tiles(&stage, combined(&lights, heuristic), &RUNS) {
                let error = tile.standard_error().expect("many");
                assert!(error < 5e-3, "{error}");
                assert!((tile.mean() - 1.75).abs() < 5.0 * error + 1e-5, "{tile:?}");
            }
        }
    }

    /// Mirrors and glass have a flag and no density; the box with both is that of chapter 13.
    #[test]
    fn what_has_no_density_counts_in_full() {
        let stage = stage(&named("cornell-glass", 0.5).expect("a scene"));
        let lights = lights(&stage);
        let runs = Runs { height: 24, depth: 3, ..RUNS };
        let by_light = tiles(&stage, ByLight { lights: &lights }, &runs);
        let other = Runs { seed: 7, ..runs };
        let both = tiles(&stage, combined(&lights, Heuristic::Power), &other);
        assert!(least_p_value(&by_light, &both) > SIGNIFICANCE);
    }

    /// What each strategy brings, added, is the whole.
    #[test]
    fn two_halves_make_a_whole() {
        let stage = stage(&Plates::VEACH.model());
        let lights = lights(&stage);
        let combined = combined(&lights, Heuristic::Balance);
        let runs = Runs { count: 2, ..RUNS };
        let whole = tiles(&stage, combined, &runs);
        let [light, direction] = [Side::Light, Side::Direction]
            .map(|side| tiles(&stage, Half { combined, side }, &runs));
        for ((whole, light), direction) in whole.iter().zip(&light).zip(&direction) {
            let sum = light.mean() + direction.mean();
            assert!((sum / whole.mean().max(1e-9) - 1.0).abs() < 1e-4 || whole.mean() == 0.0);
        }
    }
}
