//! The endings that a picture may choose from.

use common::film::Color;
use path_tracing::random::Random;
use path_tracing::strategy::Ending;

use crate::naive::Report;
use crate::roulette::{Constant, Roulette};

// ANCHOR: rule
/// When paths end. Which of them is asked once a surface, and is always the same: next to two rays
/// that costs nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// By what they carry.
    Throughput(Roulette),
    /// All equally often.
    Constant(Constant),
    /// As the report's line does it.
    Report(Report),
    /// Not before the depth.
    Never,
}

impl Ending for Rule {
    #[inline]
    fn factor(&self, throughput: Color, bounce: u32, random: &Random) -> Option<f32> {
        match self {
            Self::Throughput(roulette) => roulette.factor(throughput, bounce, random),
            Self::Constant(constant) => constant.factor(throughput, bounce, random),
            Self::Report(report) => report.factor(throughput, bounce, random),
            Self::Never => Some(1.0),
        }
    }
}
// ANCHOR_END: rule
