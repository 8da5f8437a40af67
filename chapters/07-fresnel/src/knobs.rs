//! This chapter's own options.

use clap::Args;
use ray_casting::knobs::Aim;

use crate::index::Index;
use crate::integrator::{Branching, Formula};

/// The options of this chapter alone.
#[derive(Clone, Debug, Args)]
pub struct Knobs {
    /// How the reflected part is computed
    #[arg(long, value_enum, default_value_t)]
    pub fresnel: Formula,
    /// What becomes of light that is reflected and refracted
    #[arg(long, value_enum, default_value_t)]
    pub branch: Branching,
    /// The most surfaces that a ray leaves on its way
    #[arg(long, value_name = "N", default_value_t = 5)]
    pub depth: u32,
    /// Rays are followed that bring more than this part of their light, from 0 to below 1
    #[arg(long, value_name = "PART", default_value = "0", allow_hyphen_values = true, value_parser = part)]
    pub cutoff: f32,
    /// The glass's index of refraction
    #[arg(long, value_name = "N", default_value = "1.5", allow_hyphen_values = true)]
    pub index: Index,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

impl Default for Knobs {
    fn default() -> Self {
        Self {
            fresnel: Formula::Exact,
            branch: Branching::Both,
            depth: 5,
            cutoff: 0.0,
            index: Index::GLASS,
            aim: Aim::default(),
        }
    }
}

/// A part of the light, less than all of it.
fn part(text: &str) -> Result<f32, String> {
    match text.trim().parse() {
        Ok(part) if (0.0..1.0).contains(&part) => Ok(part),
        _ => Err("a part is a number from 0 to below 1, such as 0.01".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::part;

    #[test]
    fn parts_good_and_bad() {
        assert_eq!((part("0"), part(" 0.25"), part("1e-9")), (Ok(0.0), Ok(0.25), Ok(1e-9)));
        for bad in ["", "1", "-0.1", "nan", "inf", "much"] {
            assert!(part(bad).is_err(), "{bad}");
        }
    }
}
