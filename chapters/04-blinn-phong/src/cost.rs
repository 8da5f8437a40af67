//! What accuracy costs in nanoseconds, and what the plan saves.

mod models;
mod plans;
mod powers;

use common::cost::Experiment;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let mut experiments = vec![powers::experiment(), models::experiment()];
    experiments.extend(plans::experiment().ok());
    experiments
}

/// The root of the mean of the squares of errors.
fn root_mean_square(errors: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for error in errors {
        sum += error * error;
        count += 1.0;
    }
    f64::sqrt(sum / count)
}
