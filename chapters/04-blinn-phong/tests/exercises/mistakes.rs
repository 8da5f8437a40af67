//! Wrong answers that people give, and what to tell them.

mod lamps;
mod shading;
mod surfaces;

pub(super) use lamps::of_arriving;
pub(super) use shading::of_shade;
pub(super) use surfaces::{of_highlights, of_lambert, of_stripes};
