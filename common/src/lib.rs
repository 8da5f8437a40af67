//! What no lesson changes: pixels, files, random numbers, the command line, and measuring.
//!
//! This crate knows nothing of rays or light. A chapter teaches those; what it needs around them
//! is here.
//!
//! | making a picture | measuring it | teaching with it |
//! |---|---|---|
//! | [`film`]: linear pixels, PNG and EXR | [`tally`]: counters, free when off | [`exercise`]: checks that name the mistake |
//! | [`render`]: the pixel loop | [`stats`]: errors and tests | [`report`]: expected, yours, difference |
//! | [`sampler`]: keyed random numbers | [`cost`]: accuracy against time | [`chapter`]: what each binary does |
//! | [`math`]: portable to the bit | [`hard`]: the ledger of hard cases | [`args`]: the options all share |
//! | [`obj`]: meshes and their materials | [`plan`]: the effects a scene calls for | |
//!
//! The feature `native` (on by default) holds all that touches a file, a clock, a thread or a
//! terminal. Without it the crate compiles for a web page.

pub mod cost;
pub mod exercise;
pub mod film;
pub mod hard;
pub mod math;
pub mod obj;
pub mod plan;
pub mod render;
pub mod sampler;
pub mod stats;
pub mod tally;

#[cfg(feature = "native")]
pub mod args;
#[cfg(feature = "native")]
pub mod chapter;
#[cfg(feature = "native")]
pub mod files;
#[cfg(feature = "native")]
pub mod interrupt;
#[cfg(feature = "native")]
pub mod report;
