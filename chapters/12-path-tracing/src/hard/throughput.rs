//! PT-04: what a path carries, over many surfaces.

use std::f32::consts::FRAC_1_PI;

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;

use super::CHAPTER;
use crate::naive;

/// PT-04: a product of quotients, or a quotient of products that both vanish.
pub(super) const UNDERFLOW: Case = Case {
    id: "PT-04",
    chapter: CHAPTER,
    input: "a path of 20 to 149 surfaces, each weighed by f cos / pdf",
    most: UNLIMITED,
    naive_fails: |trial| {
        let steps = steps(trial);
        let factors: Vec<(f32, f32)> = steps.iter().map(Step::factors).collect();
        is_wrong(&steps, naive::quotient_of_products(&factors))
    },
    robust_fails: |trial| {
        let steps = steps(trial);
        let weight = |step: &Step| {
            let (value, density) = step.factors();
            value / density
        };
        is_wrong(&steps, steps.iter().map(weight).product())
    },
};

/// A matte surface on the way, left at this cosine.
struct Step {
    albedo: f32,
    cosine: f32,
}

impl Step {
    /// f · cosine, and the density.
    fn factors(&self) -> (f32, f32) {
        (self.albedo * FRAC_1_PI * self.cosine, self.cosine * FRAC_1_PI)
    }
}

fn steps(trial: u64) -> Vec<Step> {
    let mut stream = Stream::of_trial(1240, trial);
    let count = 20 + stream.bits() % 130;
    let step =
        |_| Step { albedo: stream.between(0.6, 1.0), cosine: stream.between(0.0, 1.0).sqrt() };
    (0..count).map(step).filter(|step| step.cosine > 0.0).collect()
}

/// The product of the albedos in `f64`: 150 of them stay above 10⁻³⁴, where `f32` has all its digits.
/// Each step rounds five times.
fn is_wrong(steps: &[Step], found: f32) -> bool {
    let right: f64 = steps.iter().map(|step| f64::from(step.albedo)).product();
    let bound = 5.0 * steps.len() as f64 / f64::from(1 << 24);
    !((f64::from(found) - right).abs() <= bound * right)
}

#[cfg(test)]
mod tests {
    use crate::naive::quotient_of_products;

    #[test]
    fn the_page_s_worked_number() {
        // 0.25 / 0.5 a surface: after 80 of them 4^-80 is below 2^-149 and 2^-80 is not.
        let steps = |count| vec![(0.25, 0.5); count];
        assert_eq!(quotient_of_products(&steps(60)), 1.0 / (1_u64 << 60) as f32);
        assert_eq!(quotient_of_products(&steps(80)), 0.0);
        assert!(quotient_of_products(&steps(160)).is_nan());
        let (value, density) = (0.25_f32, 0.5_f32);
        let one_by_one: f32 = (0..80).map(|_| value / density).product();
        assert_eq!(f64::from(one_by_one), 1.0 / (1_u128 << 80) as f64);
    }
}
