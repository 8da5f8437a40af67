//! Wrong answers that people give, and what to tell them.

mod lamps;
mod lines;
mod offsets;
mod sides;

pub(super) use lamps::of_light_at;
pub(super) use lines::{of_sees, of_sees_lamp};
pub(super) use offsets::of_leave;
pub(super) use sides::of_arriving_cosine;
