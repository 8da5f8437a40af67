//! Wrong answers that people give, and what to tell them.

mod estimates;
mod numbers;

pub(super) use estimates::{of_colored, of_estimate, of_furnace, of_go_on};
pub(super) use numbers::{of_survival, of_variance};
