//! The exercises of chapter 14: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p russian-roulette --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 14 has the story of
//! each.

use common::film::Color;
use common::sampler::Stream;

/// Exercise 14.1, half as often, twice as much: an estimate of `radiance` that needs it in a part
/// `survival` of all cases only.
///
/// `chance` is a random number, uniform in [0, 1). Where you don't need it, the estimate is 0. The
/// mean of your estimates must be the radiance. The check takes many. See the section "Equation 4-5".
pub fn estimate(radiance: f32, survival: f32, chance: f32) -> f32 {
    let _ = (radiance, survival, chance);
    todo!("exercise 14.1")
}

/// Exercise 14.2, a whole estimator: what one path brings in a furnace.
///
/// Every surface it meets emits 1 and reflects the part `albedo` of what comes. At each surface the
/// path goes on with the probability `survival`, without a depth. `chances.uniform()` is the next random
/// number in [0, 1). The mean must be 1 / (1 - albedo). The check takes many. See the section "A path
/// without a depth".
pub fn furnace(albedo: f32, survival: f32, chances: &mut Stream) -> f32 {
    let _ = (albedo, survival, chances);
    todo!("exercise 14.2")
}

/// Exercise 14.3, what does it cost: the variance of exercise 14.2's path, or None where it is
/// infinite.
///
/// `albedo` lies between 0 and 1, `survival` is above 0 and at most 1. See the section "The price in
/// noise".
pub fn variance(albedo: f64, survival: f64) -> Option<f64> {
    let _ = (albedo, survival);
    todo!("exercise 14.3")
}

/// Exercise 14.4, by what it carries: the probability with which a path goes on.
///
/// That is the brightest colour of its throughput over `threshold`, at most 1 and, unless the path is
/// black, at least 2⁻¹². A black path has 0. See the sections "By what a path carries" and "Twenty-four
/// bits".
pub fn survival(throughput: Color, threshold: f32) -> f32 {
    let _ = (throughput, threshold);
    todo!("exercise 14.4")
}

/// Exercise 14.5, a whole estimator with colours: as exercise 14.2, but each colour has its `albedo`,
/// and the path goes on as often as your `survival` says for this `threshold`.
///
/// One decision holds for all three colours. The mean of each must be 1 / (1 - its albedo). See the
/// section "By what a path carries".
pub fn colored(albedo: Color, threshold: f32, chances: &mut Stream) -> Color {
    let _ = (albedo, threshold, chances);
    todo!("exercise 14.5")
}

/// Exercise 14.6, find the mistake: the report's line, mended.
///
/// `naive::report` should let a path go on with the probability `survival`. Give what the path counts
/// from here on, or None where it ends. `chance` is a random number, uniform in [0, 1). The check
/// draws the Cornell box with it. See the section "The report's line".
pub fn go_on(survival: f32, chance: f32) -> Option<f32> {
    let _ = (survival, chance);
    todo!("exercise 14.6")
}
