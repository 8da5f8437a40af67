//! The cures to choose from.

use glam::Vec3;
use ray_casting::shape::Hit;

use crate::naive;
use crate::spawn::spawn;

/// Where a ray starts that leaves a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Offset {
    /// In the point itself.
    None,
    /// A fixed step along the ray.
    Fixed,
    /// A fixed step along the normal.
    Normal,
    /// So many floats further along the normal.
    Integer,
    /// As far along the normal as the point may be wrong.
    #[default]
    Bound,
}

/// From a hit and a direction to the ray's origin.
pub type Leave = fn(&Hit, Vec3) -> Vec3;

impl Offset {
    /// All of them, in the order of the page.
    pub const ALL: [Self; 5] = [Self::None, Self::Fixed, Self::Normal, Self::Integer, Self::Bound];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Fixed => "fixed",
            Self::Normal => "normal",
            Self::Integer => "integer",
            Self::Bound => "bound",
        }
    }

    /// The formula.
    pub fn leave(self) -> Leave {
        match self {
            Self::None => naive::stay,
            Self::Fixed => naive::fixed,
            Self::Normal => naive::normal,
            Self::Integer => naive::integer,
            Self::Bound => spawn,
        }
    }
}
