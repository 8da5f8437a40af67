//! This chapter's own options.

use clap::{Args, ValueEnum};
use path_tracing::knobs::Knobs as PathKnobs;

use crate::lamp::Way;
use crate::lights::Choice;

/// The options of this chapter alone.
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
