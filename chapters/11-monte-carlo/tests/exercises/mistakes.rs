//! Wrong answers that people give, and what to tell them.

mod lists;
mod places;

pub(super) use lists::{of_one_of_many, of_variance};
pub(super) use places::{of_disk, of_irradiance, of_over_triangle};
