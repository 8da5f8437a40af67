//! Wrong answers that people give, and what to tell them.

mod camera;
mod quadratic;
mod shapes;

pub(super) use camera::{of_look_at_direction, of_pixel_direction};
pub(super) use quadratic::{of_hit_sphere, of_roots};
pub(super) use shapes::{of_first_seen, of_hit_disk};
