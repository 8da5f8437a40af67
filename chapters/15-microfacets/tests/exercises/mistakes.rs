//! Wrong answers that people give, and what to tell them.

mod chances;
mod formulas;

pub(super) use chances::{of_sent_back, of_visible_normal};
pub(super) use formulas::{of_density, of_reflected_density, of_seen_and_lit};
