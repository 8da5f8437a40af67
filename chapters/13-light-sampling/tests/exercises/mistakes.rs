//! Wrong answers that people give, and what to tell them.

mod counting;
mod weights;

pub(super) use counting::{of_one_lamp, of_share};
pub(super) use weights::{of_ball_density, of_density, of_direct, of_light};
