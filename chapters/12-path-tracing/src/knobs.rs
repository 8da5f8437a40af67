//! This chapter's own options.

use std::str::FromStr;

use clap::Args;
use ray_casting::knobs::Aim;

/// The options of this chapter alone.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
pub struct Knobs {
    /// The most surfaces that a path may leave; 0 shows lamps and sky only
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = 8, value_parser = depth)]
    pub depth: u32,
    /// The part of the light that the furnaces' walls reflect, from 0 to 1
    #[arg(long, value_name = "A", allow_hyphen_values = true, default_value = "0.5")]
    pub albedo: Albedo,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

// ANCHOR: depth
/// The largest depth. A path in a white room that nothing else ends takes a few hundredths of a
/// second for it, so a picture of such a room still ends, in about a day.
pub const DEEPEST: u32 = 100_000;

/// # Errors
/// Text that is no whole number from 0 to [`DEEPEST`].
pub fn depth(text: &str) -> Result<u32, String> {
    let depth: Option<u32> = text.parse().ok();
    let depth = depth.filter(|depth| (0..=DEEPEST).contains(depth));
    depth.ok_or_else(|| format!("a depth is a whole number from 0 to {DEEPEST}"))
}
// ANCHOR_END: depth

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

#[cfg(test)]
mod tests {
    use super::{Albedo, DEEPEST, depth};

    #[test]
    fn a_path_must_end() {
        assert_eq!([depth("0"), depth("8")], [Ok(0), Ok(8)]);
        assert_eq!(depth(&DEEPEST.to_string()), Ok(DEEPEST));
        for text in ["100001", "4294967295", "-1", "1.5", "", "many"] {
            assert!(depth(text).is_err_and(|told| told.contains("from 0 to 100000")), "{text}");
        }
    }

    #[test]
    fn nothing_reflects_more_than_all() {
        assert_eq!("1".parse(), Ok(Albedo(1.0)));
        for text in ["1.0001", "-0.1", "nan", "inf", "white"] {
            assert!(text.parse::<Albedo>().is_err(), "{text}");
        }
    }
}
