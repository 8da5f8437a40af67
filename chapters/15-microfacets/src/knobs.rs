//! This chapter's own options.

use std::str::FromStr;

use clap::{Args, ValueEnum};
use russian_roulette::knobs::Knobs as PathKnobs;

use crate::facets::{Facets, Masking, Normals};

/// The options of this chapter alone.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
pub struct Knobs {
    /// The roughness of all rough things, from 0 to 1, instead of their own
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    pub roughness: Option<Roughness>,
    /// Which facets a path meets
    #[arg(long, value_enum, default_value_t)]
    pub normals: NormalsChoice,
    /// How often a facet is both seen and lit
    #[arg(long, value_enum, default_value_t)]
    pub masking: MaskingChoice,
    /// Those of chapters 12 to 14.
    #[command(flatten)]
    pub path: PathKnobs,
}

impl Knobs {
    /// Facets as the options want them.
    pub fn apply(&self, facets: &mut Facets) {
        if let Some(Roughness(alpha)) = self.roughness {
            facets.ggx.alpha = alpha;
        }
        facets.normals = match self.normals {
            NormalsChoice::Visible => Normals::Visible,
            NormalsChoice::All => Normals::All,
        };
        facets.masking = match self.masking {
            MaskingChoice::Correlated => Masking::Correlated,
            MaskingChoice::Separable => Masking::Separable,
        };
    }
}

/// Which facets a path meets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum NormalsChoice {
    /// Those that are seen.
    #[default]
    Visible,
    /// All, as if looked at from above.
    All,
}

/// How often a facet is both seen and lit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum MaskingChoice {
    /// One high up is both, one in a pit neither.
    #[default]
    Correlated,
    /// As if one had nothing to do with the other.
    Separable,
}

/// A roughness, from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roughness(pub f32);

impl FromStr for Roughness {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let roughness: Option<f32> = text.parse().ok();
        match roughness.filter(|roughness| (0.0..=1.0).contains(roughness)) {
            Some(roughness) => Ok(Self(roughness)),
            None => Err("a roughness is a number from 0 to 1".into()),
        }
    }
}
