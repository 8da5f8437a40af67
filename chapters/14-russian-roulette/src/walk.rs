//! A path in a furnace, without the furnace: only what it carries.

use common::film::Color;
use common::sampler::Sampler;
use path_tracing::random::Random;
use path_tracing::strategy::Ending;

// ANCHOR: walk
/// What a path brought, and how many surfaces it left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walk {
    /// An estimate of the radiance in the furnace.
    pub radiance: Color,
    /// How often it went on.
    pub bounces: u32,
}

/// A path in a room whose walls emit 1 and reflect `albedo`, below 1: wherever it goes it meets the
/// same.
pub fn walk<E: Ending>(albedo: Color, ending: &E, sampler: &Sampler) -> Walk {
    let (mut radiance, mut throughput) = (Color::ZERO, Color::ONE);
    for bounces in 0.. {
        radiance += throughput;
        throughput *= albedo;
        let random = Random::at(sampler, bounces + 1);
        match ending.factor(throughput, bounces + 1, &random) {
            Some(factor) => throughput *= factor,
            None => return Walk { radiance, bounces },
        }
    }
    Walk { radiance, bounces: u32::MAX }
}
// ANCHOR_END: walk

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::sampler::Sampler;
    use common::stats::estimate::t_test;
    use common::stats::running::Running;

    use super::walk;
    use crate::roulette::Roulette;

    #[test]
    fn each_colour_has_its_own_mean() {
        let albedo = Color::new(0.7, 0.2, 0.0);
        for threshold in [0.25, 0.5, 1.0, 2.0] {
            let mut means = [Running::default(); 3];
            for trial in 0..50_000 {
                let sampler = Sampler::new(140, trial, 0, 1);
                let found = walk(albedo, &Roulette { threshold }, &sampler).radiance;
                for (mean, part) in means.iter_mut().zip(found.to_array()) {
                    mean.add(f64::from(part));
                }
            }
            for (mean, albedo) in means.iter().zip(albedo.to_array()) {
                let expected = 1.0 / (1.0 - f64::from(albedo));
                let test = t_test(mean, expected).expect("many samples");
                assert!(test.p_value > 0.001, "{threshold}: {mean:?} {expected}");
            }
        }
    }
}
