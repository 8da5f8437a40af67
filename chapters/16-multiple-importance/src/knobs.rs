//! This chapter's own options.

use clap::{Args, ValueEnum};
use light_sampling::knobs::LampChoice;
use light_sampling::lamp::Way;
use microfacets::knobs::Roughness;
use path_tracing::knobs::{Albedo, depth};
use ray_casting::knobs::Aim;
use russian_roulette::knobs::Threshold;

use crate::heuristic::Heuristic;
use crate::reuse::Division;

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
    /// Pixels along a side of the squares whose pixels share their paths
    #[arg(long, value_name = "N", value_enum, default_value_t)]
    pub reuse: Side,
    /// How a shared path is divided among the pixels that see its second vertex
    #[arg(long, value_enum, default_value_t)]
    pub division: DivisionChoice,
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

/// The side of a square of pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Side {
    /// Each pixel has its own paths.
    #[default]
    #[value(name = "1")]
    One,
    /// Four pixels share.
    #[value(name = "2")]
    Two,
    /// Sixteen.
    #[value(name = "4")]
    Four,
    /// Sixty-four.
    #[value(name = "8")]
    Eight,
}

impl Side {
    /// In pixels.
    pub fn side(self) -> u32 {
        match self {
            Self::One => 1,
            Self::Two => 2,
            Self::Four => 4,
            Self::Eight => 8,
        }
    }
}

/// How a shared path is divided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum DivisionChoice {
    /// By the densities with which pixels would have found the vertex.
    #[default]
    Balance,
    /// Evenly, which is wrong.
    Even,
}

impl From<DivisionChoice> for Division {
    fn from(choice: DivisionChoice) -> Self {
        match choice {
            DivisionChoice::Balance => Self::Balance,
            DivisionChoice::Even => Self::Even,
        }
    }
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
