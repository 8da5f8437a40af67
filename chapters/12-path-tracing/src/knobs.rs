//! This chapter's own options.

use std::str::FromStr;

use clap::Args;
use ray_casting::knobs::Aim;

/// The options of this chapter alone.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
pub struct Knobs {
    /// The most surfaces that a path may leave; 0 shows lamps and sky only
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = 8)]
    pub depth: u32,
    /// The part of the light that the furnaces' walls reflect, from 0 to 1
    #[arg(long, value_name = "A", allow_hyphen_values = true, default_value = "0.5")]
    pub albedo: Albedo,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

/// The part of light that is reflected, from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Albedo(pub f32);

impl FromStr for Albedo {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let albedo: Option<f32> = text.parse().ok();
        match albedo.filter(|albedo| (0.0..=1.0).contains(albedo)) {
            Some(albedo) => Ok(Self(albedo)),
            None => Err("an albedo is a number from 0 to 1".into()),
        }
    }
}
