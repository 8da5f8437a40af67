//! This chapter's own options.

use std::str::FromStr;

use clap::{Args, ValueEnum};
use light_sampling::knobs::{LampChoice, LightingChoice};
use path_tracing::knobs::{Albedo, depth};
use ray_casting::knobs::Aim;

use crate::ending::Rule;
use crate::naive::Report;
use crate::roulette::{Constant, Roulette};

/// The options of this chapter alone.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
pub struct Knobs {
    /// When paths end: throughput, constant, report, off, or how often they go on, such as 0.8
    #[arg(long, value_name = "RULE|P", allow_hyphen_values = true, default_value = "throughput")]
    pub roulette: Choice,
    /// How often paths go on, with --roulette constant and report
    #[arg(long, value_name = "P", allow_hyphen_values = true, default_value = "0.8")]
    pub survival: Survival,
    /// Below which throughput paths may end, with --roulette throughput
    #[arg(long, value_name = "T", allow_hyphen_values = true, default_value = "0.5")]
    pub threshold: Threshold,
    /// The most surfaces that a path may leave, whatever chance says
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = 1000, value_parser = depth)]
    pub depth: u32,
    /// How light is looked for
    #[arg(long, value_enum, default_value_t)]
    pub lighting: LightingChoice,
    /// Which lamp is looked at
    #[arg(long, value_enum, default_value_t)]
    pub lamps: LampChoice,
    /// How paths are followed
    #[arg(long, value_enum, default_value_t)]
    pub paths: Paths,
    /// The part of the light that the furnaces' walls reflect, from 0 to 1
    #[arg(long, value_name = "A", allow_hyphen_values = true, default_value = "0.5")]
    pub albedo: Albedo,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

impl Knobs {
    /// When paths end.
    pub fn rule(&self) -> Rule {
        let Survival(survival) = self.survival;
        match self.roulette {
            Choice::Throughput => Rule::Throughput(Roulette { threshold: self.threshold.0 }),
            Choice::Constant => Rule::Constant(survival),
            Choice::Given(Survival(given)) => Rule::Constant(given),
            Choice::Report => Rule::Report(Report { probability: survival.probability() }),
            Choice::Off => Rule::Never,
        }
    }
}

/// How paths are followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Paths {
    /// Sixteen side by side, in scenes of a few matte triangles; the picture is the same, to the bit.
    #[default]
    Abreast,
    /// One after another.
    Single,
}

/// When paths end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Choice {
    /// By what they carry.
    Throughput,
    /// All as often as `--survival` says.
    Constant,
    /// All as often as this says.
    Given(Survival),
    /// The report's line.
    Report,
    /// Never.
    Off,
}

impl FromStr for Choice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "throughput" => Ok(Self::Throughput),
            "constant" => Ok(Self::Constant),
            "report" => Ok(Self::Report),
            "off" => Ok(Self::Off),
            number => number.parse().map(Self::Given).map_err(|error: String| {
                format!("it is throughput, constant, report, off, or a number: {error}")
            }),
        }
    }
}

/// How often paths go on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Survival(pub Constant);

impl FromStr for Survival {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let survival = text.parse().ok().and_then(Constant::new).map(Self);
        survival.ok_or_else(|| "a survival is a number from 1/4096 to 1".into())
    }
}

/// A throughput, at least 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold(pub f32);

impl FromStr for Threshold {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let threshold: Option<f32> = text.parse().ok();
        match threshold.filter(|it| it.is_finite() && *it >= 0.0) {
            Some(threshold) => Ok(Self(threshold)),
            None => Err("a threshold is a number, at least 0".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Choice, Survival, Threshold};
    use crate::roulette::Constant;

    #[test]
    fn a_rule_or_a_probability() {
        assert_eq!("throughput".parse(), Ok(Choice::Throughput));
        assert_eq!("off".parse(), Ok(Choice::Off));
        assert_eq!("0.8".parse(), Ok(Choice::Given(Survival(Constant::REPORT))));
        for text in ["0", "1e-10", "1.01", "-0.5", "nan", "russian", ""] {
            assert!(text.parse::<Choice>().is_err(), "{text}");
        }
    }

    #[test]
    fn thresholds_are_throughputs() {
        assert_eq!("0".parse(), Ok(Threshold(0.0)));
        for text in ["-1", "nan", "inf", "much"] {
            assert!(text.parse::<Threshold>().is_err(), "{text}");
        }
    }
}
