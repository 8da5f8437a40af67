//! This chapter's own options.

use blinn_phong::light::{Light, LightError};
use common::film::Color;
use ray_casting::knobs::{Aim, Point};

use crate::offset::Offset;

/// The options of this chapter alone.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub struct Knobs {
    /// Where a ray starts that leaves a surface
    #[arg(long, value_enum, default_value_t)]
    pub offset: Offset,
    /// A white lamp at this place, instead of the scene's own lamps
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub lamp: Option<Point>,
    /// A white lamp far away in this direction, instead of the scene's own lamps
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub sun: Option<Point>,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

impl Knobs {
    /// The lamps that the options ask for.
    ///
    /// # Errors
    /// A direction that is none.
    pub fn lamps(&self) -> Result<Vec<Light>, LightError> {
        let lamp = self.lamp.map(|Point(position)| Light::steady(position, Color::ONE));
        let sun = self.sun.map(|Point(toward)| Light::far(toward, Color::ONE)).transpose()?;
        Ok(lamp.into_iter().chain(sun).collect())
    }
}
