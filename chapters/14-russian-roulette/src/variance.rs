//! What ending paths costs in variance, where it is known: in a furnace.

// ANCHOR: variance
/// The variance of what one path brings in a furnace of this `albedo`, from 0 to 1 (both excluded),
/// when it goes on with the probability `survival`. `None` where it is infinite.
///
/// From X = 1 + (a / P) X', where X' is the rest of a path that goes on.
pub fn constant(albedo: f64, survival: f64) -> Option<f64> {
    let square = albedo * albedo;
    let dark = (1.0 - albedo) * (1.0 - albedo);
    (survival > square).then(|| square * (1.0 - survival) / (dark * (survival - square)))
}
// ANCHOR_END: variance

/// How many surfaces such a path meets on average: 1 + P + P² + …
pub fn length(survival: f64) -> f64 {
    1.0 / (1.0 - survival)
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::sampler::Sampler;
    use common::stats::running::Running;

    use super::{constant, length};
    use crate::roulette::Constant;
    use crate::walk::walk;

    #[test]
    fn by_hand() {
        // Albedo 0.8: 0.64 · 0.2 / (0.04 · 0.16), and 0.64 · 0.1 / (0.04 · 0.26).
        assert!((constant(0.8, 0.8).expect("finite") - 20.0).abs() < 1e-9);
        assert!((constant(0.8, 0.9).expect("finite") - 6.153_846).abs() < 1e-6);
        assert_eq!(constant(0.9, 0.8), None, "0.8 is below 0.81");
        assert!((length(0.8) - 5.0).abs() < 1e-12);
    }

    #[test]
    fn paths_have_the_variance_and_the_length_that_are_derived() {
        for (albedo, survival) in [(0.5_f32, 0.5_f32), (0.5, 0.8), (0.8, 0.8), (0.8, 0.95)] {
            let ending = Constant::new(survival).expect("a probability");
            let (mut radiance, mut surfaces) = (Running::default(), Running::default());
            for trial in 0..200_000 {
                let sampler = Sampler::new(141, trial, 0, 1);
                let found = walk(Color::splat(albedo), &ending, &sampler);
                radiance.add(f64::from(found.radiance.x));
                surfaces.add(f64::from(found.bounces + 1));
            }
            let (albedo, survival) = (f64::from(albedo), f64::from(survival));
            let expected = constant(albedo, survival).expect("finite");
            let found = radiance.variance().expect("many samples");
            assert!((found / expected - 1.0).abs() < 0.1, "{albedo} {survival}: {found}");
            assert!((surfaces.mean() / length(survival) - 1.0).abs() < 0.02);
        }
    }
}
