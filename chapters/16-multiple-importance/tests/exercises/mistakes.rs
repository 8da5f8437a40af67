//! Wrong answers that people give, and what to tell them.

mod estimates;
mod weights;

pub(super) use estimates::{of_combined, of_one_of_two};
pub(super) use weights::{of_power, of_share, of_weight_by_area};
