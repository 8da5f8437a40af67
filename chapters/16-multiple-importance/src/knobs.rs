//! This chapter's own options.

use clap::{Args, ValueEnum};
use light_sampling::knobs::LampChoice;
use light_sampling::lamp::Way;
use microfacets::knobs::Roughness;
use path_tracing::knobs::{Albedo, depth};
use ray_casting::knobs::Aim;
use russian_roulette::knobs::Threshold;

use crate::heuristic::Heuristic;

/// The options of this chapter's program.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
pub struct Knobs {
    /// How light is looked for
    #[arg(long, value_enum, default_value_t)]
    pub lighting: LightingChoice,
    /// How two strategies share what both can find
    #[arg(long, value_enum, default_value_t)]
    pub heuristic: HeuristicChoice,
    /// How points of lamps are chosen
    #[arg(long, value_enum, default_value_t)]
    pub way: WayChoice,
    /// Which lamp is looked at
    #[arg(long, value_enum, default_value_t)]
    pub lamps: LampChoice,
    /// The throughput below which a path may end by chance; 0 lets none end that carries anything
    #[arg(long, value_name = "T", allow_hyphen_values = true, default_value = "0.5")]
    pub threshold: Threshold,
    /// The most surfaces that a path may leave, whatever chance says
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = 1000, value_parser = depth)]
    pub depth: u32,
    /// The roughness of all rough things, from 0 to 1, instead of their own
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    pub roughness: Option<Roughness>,
    /// The part of the light that the furnaces' walls reflect, from 0 to 1
    #[arg(long, value_name = "A", allow_hyphen_values = true, default_value = "0.5")]
    pub albedo: Albedo,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

/// How light is looked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum LightingChoice {
    /// In both ways.
    #[default]
    Combined,
    /// At lamps, as in chapter 13.
    Light,
    /// Nowhere: paths come upon lamps by chance, as in chapter 12.
    Direction,
    /// In both ways; only what was found at lamps is shown.
    LightHalf,
    /// In both ways; only what paths came upon is shown.
    DirectionHalf,
}

/// How two strategies share.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum HeuristicChoice {
    /// By densities.
    Balance,
    /// By their squares.
    #[default]
    Power,
}

/// How points of lamps are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum WayChoice {
    /// Evenly over lamps.
    Area,
    /// Evenly over what is seen of them.
    #[default]
    SolidAngle,
}

impl From<HeuristicChoice> for Heuristic {
    fn from(choice: HeuristicChoice) -> Self {
        match choice {
            HeuristicChoice::Balance => Self::Balance,
            HeuristicChoice::Power => Self::Power,
        }
    }
}

impl From<WayChoice> for Way {
    fn from(choice: WayChoice) -> Self {
        match choice {
            WayChoice::Area => Self::Area,
            WayChoice::SolidAngle => Self::SolidAngle,
        }
    }
}

#[cfg(test)]
mod tests {
    use light_sampling::lamp::Way;

    use super::{HeuristicChoice, WayChoice};
    use crate::heuristic::Heuristic;

    #[test]
    fn what_is_said_is_what_is_done() {
        let rules: [Heuristic; 2] =
            [HeuristicChoice::Balance.into(), HeuristicChoice::Power.into()];
        assert_eq!(rules, [Heuristic::Balance, Heuristic::Power]);
        assert_eq!(HeuristicChoice::default(), HeuristicChoice::Power);
        let ways: [Way; 2] = [WayChoice::Area.into(), WayChoice::SolidAngle.into()];
        assert_eq!(ways, [Way::Area, Way::SolidAngle]);
    }
}
