//! Wrong answers that people give, and what to tell them.

mod bending;
mod parts;

pub(super) use bending::{of_far_cosine, of_refract};
pub(super) use parts::{of_one_of_two, of_reflectance, of_schlick, of_seen};
