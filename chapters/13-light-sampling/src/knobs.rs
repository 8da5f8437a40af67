//! This chapter's own options.

use clap::{Args, ValueEnum};
use path_tracing::knobs::Knobs as PathKnobs;

use crate::lamp::Way;
use crate::lights::Choice;

/// The options of this chapter's program.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
pub struct Options {
    /// What counts of a lamp that a path comes upon by itself, though lamps are looked for
    #[arg(long, value_enum, default_value_t)]
    pub met: Counting,
    /// Those that later chapters share.
    #[command(flatten)]
    pub light: Knobs,
}

/// What counts of a lamp that a path comes upon by itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Counting {
    /// What could not be looked for.
    #[default]
    Once,
    /// What the eye sees, and no more: the report's rule, wrong for mirrors and glass.
    Camera,
    /// All of it, some for the second time: wrong for what is matte.
    Twice,
}

/// The options of light that is looked for.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
pub struct Knobs {
    /// How light is looked for
    #[arg(long, value_enum, default_value_t)]
    pub lighting: LightingChoice,
    /// Which lamp is looked at
    #[arg(long, value_enum, default_value_t)]
    pub lamps: LampChoice,
    /// Chapter 12's options.
    #[command(flatten)]
    pub path: PathKnobs,
}

/// How light is looked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum LightingChoice {
    /// At points spread evenly over lamps.
    #[default]
    Area,
    /// In directions spread evenly over what is seen of lamps.
    SolidAngle,
    /// Nowhere: paths come upon lamps by chance, as in chapter 12.
    Direction,
}

/// Which lamp is looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum LampChoice {
    /// Each as often as its power says.
    #[default]
    Power,
    /// All as often.
    Uniform,
}

impl LightingChoice {
    /// How points of lamps are chosen; `None` where they are not looked for.
    pub fn way(self) -> Option<Way> {
        match self {
            Self::Area => Some(Way::Area),
            Self::SolidAngle => Some(Way::SolidAngle),
            Self::Direction => None,
        }
    }
}

impl From<LampChoice> for Choice {
    fn from(choice: LampChoice) -> Self {
        match choice {
            LampChoice::Power => Self::Power,
            LampChoice::Uniform => Self::Uniform,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{LampChoice, LightingChoice};
    use crate::lamp::Way;
    use crate::lights::Choice;

    #[test]
    fn what_is_said_is_what_is_done() {
        let ways = [LightingChoice::Area, LightingChoice::SolidAngle, LightingChoice::Direction];
        assert_eq!(ways.map(LightingChoice::way), [Some(Way::Area), Some(Way::SolidAngle), None]);
        let choices: [Choice; 2] = [LampChoice::Power.into(), LampChoice::Uniform.into()];
        assert_eq!(choices, [Choice::Power, Choice::Uniform]);
    }
}
