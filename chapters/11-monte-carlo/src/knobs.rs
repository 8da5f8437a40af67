//! This chapter's own options.

use clap::Args;

use crate::points::Points;

/// The most points a picture shows.
const MOST: i64 = 1 << 16;

/// The options of this chapter alone.
#[derive(Clone, Copy, Debug, Args)]
pub struct Knobs {
    /// How points are spread, in the scenes `warps` and `convergence`
    #[arg(long, value_enum, default_value = "sobol")]
    pub points: Points,
    /// How many points each square has
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=MOST))]
    pub count: u32,
}
