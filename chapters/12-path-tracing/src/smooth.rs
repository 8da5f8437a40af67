//! The materials of this chapter.

use common::film::Color;
use common::plan::Effect;
use glam::Vec3;

use crate::bsdf::{Bsdf, BsdfSample, Material, MaterialError, check_reflectance};
use crate::glass::Glass;
use crate::lambert::Lambert;
use crate::mirror::Mirror;
use crate::random::Random;

// ANCHOR: smooth
/// A material whose surface is either perfectly rough or perfectly smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Smooth {
    /// Scatters light in all directions.
    Lambert(Lambert),
    /// Reflects it in one.
    Mirror(Mirror),
    /// Reflects it in one and lets it through in another.
    Glass(Glass),
}
// ANCHOR_END: smooth

impl Bsdf for Smooth {
    #[inline]
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        match self {
            Self::Lambert(lambert) => lambert.eval(outgoing, incoming),
            Self::Mirror(_) | Self::Glass(_) => Color::ZERO,
        }
    }

    #[inline]
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        match self {
            Self::Lambert(lambert) => lambert.pdf(outgoing, incoming),
            Self::Mirror(_) | Self::Glass(_) => 0.0,
        }
    }

    #[inline]
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        match self {
            Self::Lambert(lambert) => lambert.sample(outgoing, random),
            Self::Mirror(mirror) => mirror.sample(outgoing, random),
            Self::Glass(glass) => glass.sample(outgoing, random),
        }
    }

    #[inline]
    fn spreads(&self) -> bool {
        matches!(self, Self::Lambert(lambert) if lambert.spreads())
    }
}

impl Smooth {
    /// The material where no mirror and no glass is simulated.
    pub fn lambert(&self) -> Option<Lambert> {
        match self {
            Self::Lambert(lambert) => Some(*lambert),
            Self::Mirror(_) | Self::Glass(_) => None,
        }
    }

    /// A matte material.
    pub const fn matte(red: f32, green: f32, blue: f32) -> Self {
        Self::Lambert(Lambert::new(red, green, blue))
    }

    /// A material that reflects nothing.
    pub const BLACK: Self = Self::Lambert(Lambert::BLACK);
}

impl Material for Smooth {
    fn check(&self) -> Result<(), MaterialError> {
        match self {
            Self::Lambert(lambert) => check_reflectance(lambert.reflectance),
            Self::Mirror(mirror) => check_reflectance(mirror.reflectance),
            Self::Glass(_) => Ok(()),
        }
    }

    fn effect(&self) -> Option<Effect> {
        match self {
            Self::Lambert(_) => None,
            Self::Mirror(_) => Some(Effect::MirrorReflection),
            Self::Glass(_) => Some(Effect::Refraction),
        }
    }

    fn reflects(&self) -> bool {
        match self {
            Self::Lambert(lambert) => lambert.spreads(),
            Self::Mirror(mirror) => mirror.reflectance != Color::ZERO,
            Self::Glass(_) => true,
        }
    }
}
