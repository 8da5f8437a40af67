//! Wrong answers that people give, and what to tell them.

mod paths;
mod weights;

pub(super) use paths::{of_furnace, of_tiny_path};
pub(super) use weights::{of_camera_light, of_depth, of_weight};
