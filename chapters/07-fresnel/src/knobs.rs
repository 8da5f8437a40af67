//! This chapter's own options.

use clap::Args;
use ray_casting::knobs::Aim;
use whitted::knobs::Cutoff;
use whitted::limits::Limits;

use crate::index::Index;
use crate::path::{Branching, Formula};

/// The options of this chapter alone.
#[derive(Clone, Copy, Debug, Args)]
pub struct Knobs {
    /// How the reflected part is computed
    #[arg(long, value_enum, default_value_t)]
    pub fresnel: Formula,
    /// What becomes of light that is both reflected and refracted
    #[arg(long, value_enum, default_value_t)]
    pub branch: Branching,
    /// The most surfaces that a ray leaves on its way; 0 follows none
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = 5)]
    pub depth: u32,
    /// Follow a ray only if more than this part of its light reaches the eye: from 0 to below 1
    #[arg(long, value_name = "X", allow_hyphen_values = true, default_value = "0.001")]
    pub cutoff: Cutoff,
    /// The glass's index of refraction, in scenes whose glass has none of its own
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value = "1.5")]
    pub index: Index,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

impl Default for Knobs {
    fn default() -> Self {
        let (fresnel, branch) = (Formula::Exact, Branching::Both);
        let (depth, cutoff, index) = (5, Cutoff(0.001), Index::GLASS);
        Self { fresnel, branch, depth, cutoff, index, aim: Aim::default() }
    }
}

impl Knobs {
    /// Where following rays ends.
    pub fn limits(&self) -> Limits {
        Limits { depth: self.depth, cutoff: self.cutoff.0 }
    }
}
