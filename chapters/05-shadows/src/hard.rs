//! The chapter's hard cases.

pub(crate) mod ball;
pub(crate) mod draw;
pub(crate) mod grid;
