//! This chapter's own options.

use std::str::FromStr;

use common::chapter::Failure;
use ray_casting::knobs::Aim;

use crate::limits::Limits;
use crate::picture::Tracing;
use crate::recursion::MOST_RECURSION;

/// The deepest that rays can be asked to go. Deeper ones between mirrors that return everything would
/// keep a picture, and Ctrl-C, waiting for hours.
pub const MOST_DEPTH: i64 = 1_000_000;

/// The options of this chapter alone.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct Knobs {
    /// The most mirrors that a ray is followed through; 0 follows none
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = 5, value_parser = clap::value_parser!(u32).range(..=MOST_DEPTH))]
    pub depth: u32,
    /// Follow a ray only if more than this part of its light reaches the eye: from 0 to below 1
    #[arg(long, value_name = "X", allow_hyphen_values = true, default_value = "0.001")]
    pub cutoff: Cutoff,
    /// How rays are followed
    #[arg(long, value_enum, default_value_t)]
    pub trace: Tracing,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

impl Default for Knobs {
    fn default() -> Self {
        let (depth, cutoff) = (5, Cutoff(0.001));
        Self { depth, cutoff, trace: Tracing::default(), aim: Aim::default() }
    }
}

impl Knobs {
    /// Where following rays ends.
    ///
    /// # Errors
    /// A depth that a recursion can't go to.
    pub fn limits(&self) -> Result<Limits, Failure> {
        if self.trace == Tracing::Recursion && self.depth > MOST_RECURSION {
            return Err(Failure::Usage(format!(
                "--trace recursion goes no deeper than {MOST_RECURSION}, because each mirror takes a \
                 piece of the stack; --trace loop goes to --depth {} and gives the same bits",
                self.depth
            )));
        }
        Ok(Limits { depth: self.depth, cutoff: self.cutoff.0 })
    }
}

/// A part of the light on the command line, from 0 to below 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutoff(pub f32);

impl FromStr for Cutoff {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim().parse::<f32>() {
            Ok(part) if (0.0..1.0).contains(&part) => Ok(Self(part)),
            _ => Err("a cut-off is a part of the light from 0 to below 1, such as 0.001".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use common::chapter::Failure;

    use super::{Cutoff, Knobs};
    use crate::picture::Tracing;

    #[test]
    fn cutoffs_good_and_bad() {
        for (text, part) in [("0", 0.0), ("-0", -0.0), (" 0.25", 0.25), ("1e-30", 1e-30)] {
            assert_eq!(text.parse(), Ok(Cutoff(part)));
        }
        for bad in ["", "nan", "inf", "-1", "-1e-9", "1", "2", "1e400", "a half", "0.99999999999"] {
            assert!(bad.parse::<Cutoff>().is_err(), "{bad}");
        }
    }

    #[test]
    fn a_recursion_that_no_stack_holds_is_refused() {
        let knobs = |trace, depth| Knobs { trace, depth, ..Knobs::default() };
        for depth in [0, 500] {
            assert!(knobs(Tracing::Recursion, depth).limits().is_ok());
        }
        for depth in [501, 1_000_000] {
            assert!(knobs(Tracing::Loop, depth).limits().is_ok_and(|limits| limits.depth == depth));
            let refused = knobs(Tracing::Recursion, depth).limits();
            assert!(matches!(refused, Err(Failure::Usage(text)) if text.contains("--trace loop")));
        }
    }
}
