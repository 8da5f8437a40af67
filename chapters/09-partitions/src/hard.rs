//! The chapter's hard cases.

pub(crate) mod rays;
pub(crate) mod scenes;
