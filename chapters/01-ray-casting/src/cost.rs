//! What accuracy costs in nanoseconds.

mod directions;
mod roots;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    vec![roots::experiment(), directions::experiment()]
}

/// The root of the mean of the squares of errors that count at most 1.
fn root_mean_square(errors: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for error in errors {
        // NaN is no better than entirely wrong.
        let error = if error <= 1.0 { error } else { 1.0 };
        sum += error * error;
        count += 1.0;
    }
    (sum / count).sqrt()
}
