//! The options every chapter's program takes.

use std::path::PathBuf;
use std::str::FromStr;

use clap::{Args, Parser, Subcommand};

use crate::plan::Simulate;

/// A chapter's command line: the shared options, the chapter's own knobs, and its subcommands.
#[derive(Debug, Parser)]
#[command(args_conflicts_with_subcommands = true)]
pub struct Cli<Knobs: Args> {
    /// Without a subcommand the program renders.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// The options of every render.
    #[command(flatten)]
    pub render: RenderArgs,
    /// The options of this chapter alone.
    #[command(flatten)]
    pub knobs: Knobs,
}

/// What a chapter's program can do besides rendering.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Accuracy against time: a table, a CSV file and a plot
    Cost(CostArgs),
    /// The hard cases: naive against robust
    Hard(HardArgs),
}

/// The options of every render.
#[derive(Clone, Debug, Args)]
pub struct RenderArgs {
    /// What to render: a built-in scene, or a file
    #[arg(long, value_name = "NAME|FILE")]
    pub scene: Option<String>,
    /// Pixels across and down
    #[arg(long, allow_hyphen_values = true, value_name = "WxH")]
    pub size: Option<Size>,
    /// Samples per pixel
    #[arg(long, allow_hyphen_values = true, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=MOST_SAMPLES))]
    pub spp: Option<u32>,
    /// Which random numbers: the same seed gives the same picture
    #[arg(long, allow_hyphen_values = true, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Threads; one for each processor if not said
    #[arg(long, allow_hyphen_values = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MOST_THREADS))]
    pub threads: Option<u16>,
    /// Where the picture goes: a .png or .exr file
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// The effects to simulate; the picture is the same either way
    #[arg(long, value_enum, default_value_t)]
    pub simulate: Simulate,
    /// Whether to count the work done; off is a little faster
    #[arg(long, value_enum, default_value_t)]
    pub tally: TallyChoice,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
}

/// Whether to count the work done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum TallyChoice {
    /// Count.
    #[default]
    On,
    /// Don't.
    Off,
}

/// The options of `cost`.
#[derive(Clone, Debug, Args)]
pub struct CostArgs {
    /// Timed rounds; the methods take turns in each
    #[arg(long, value_name = "N", default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub rounds: u16,
    /// Where the plot goes; the table goes beside it as .csv
    #[arg(long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
}

/// The options of `hard`.
#[derive(Clone, Debug, Args)]
pub struct HardArgs {
    /// Trials of each case that draws its inputs at random
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = clap::value_parser!(u64).range(1..))]
    pub trials: u64,
    /// Where the picture goes, in the chapters whose hard cases have one
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Print the ledger as JSON
    #[arg(long)]
    pub json: bool,
}

const MOST_SAMPLES: i64 = 1 << 24;
const MOST_THREADS: i64 = 1024;
/// 2²⁶ pixels of 12 bytes are held up to three times: 2.3 GiB at the most.
const MOST_PIXELS: u64 = 1 << 26;

/// A picture's size in pixels, written as in 640x480.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "a size is written WIDTHxHEIGHT, such as 640x480".to_string();
        let (width, height) = text.split_once(['x', 'X']).ok_or_else(wrong)?;
        let number = |text: &str| text.trim().parse::<u32>().map_err(|_| wrong());
        let size = Self { width: number(width)?, height: number(height)? };
        match u64::from(size.width) * u64::from(size.height) {
            0 => Err("a picture needs at least one pixel across and one down".into()),
            pixels if pixels > MOST_PIXELS => Err(format!(
                "that is {pixels} pixels; the most is {MOST_PIXELS}, such as 8192x8192"
            )),
            _ => Ok(size),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Size;

    #[test]
    fn sizes_good_and_bad() {
        assert_eq!("1280x960".parse(), Ok(Size { width: 1280, height: 960 }));
        for bad in
            ["", "x", "640", "0x0", "0x5", "-1x5", "640x480x3", "99999999x99999999", "NaNxinf"]
        {
            assert!(bad.parse::<Size>().is_err(), "{bad}");
        }
    }
}
