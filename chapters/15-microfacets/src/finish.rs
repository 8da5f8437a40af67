//! The materials of chapters 12 and 15.

use common::film::Color;
use common::plan::Effect;
use glam::Vec3;
use path_tracing::bsdf::{Bsdf, BsdfSample, Material, MaterialError};
use path_tracing::lambert::Lambert;
use path_tracing::random::Random;
use path_tracing::smooth::Smooth;

use crate::facets::Facets;
use crate::rough::Rough;

// ANCHOR: finish
/// A surface of any finish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finish {
    /// Chapter 12's: matte, a mirror, or clear glass.
    Smooth(Smooth),
    /// In between.
    Rough(Rough),
}
// ANCHOR_END: finish

impl Finish {
    /// The material where nothing rough is simulated.
    pub fn smooth(&self) -> Option<Smooth> {
        match self {
            Self::Smooth(smooth) => Some(*smooth),
            Self::Rough(_) => None,
        }
    }

    /// The material where nothing rough, no mirror and no glass is simulated.
    pub fn lambert(&self) -> Option<Lambert> {
        self.smooth().and_then(|smooth| smooth.lambert())
    }

    /// The same, its facets changed where it has some.
    pub fn with_facets(mut self, change: impl Fn(&mut Facets)) -> Self {
        if let Self::Rough(rough) = &mut self {
            change(rough.facets_mut());
        }
        self
    }
}

impl From<Smooth> for Finish {
    fn from(smooth: Smooth) -> Self {
        Self::Smooth(smooth)
    }
}

impl From<Rough> for Finish {
    fn from(rough: Rough) -> Self {
        Self::Rough(rough)
    }
}

impl Bsdf for Finish {
    #[inline]
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        match self {
            Self::Smooth(smooth) => smooth.eval(outgoing, incoming),
            Self::Rough(rough) => rough.eval(outgoing, incoming),
        }
    }

    #[inline]
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        match self {
            Self::Smooth(smooth) => smooth.pdf(outgoing, incoming),
            Self::Rough(rough) => rough.pdf(outgoing, incoming),
        }
    }

    #[inline]
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        match self {
            Self::Smooth(smooth) => smooth.sample(outgoing, random),
            Self::Rough(rough) => rough.sample(outgoing, random),
        }
    }

    #[inline]
    fn spreads(&self) -> bool {
        match self {
            Self::Smooth(smooth) => smooth.spreads(),
            Self::Rough(rough) => rough.spreads(),
        }
    }
}

impl Material for Finish {
    fn check(&self) -> Result<(), MaterialError> {
        match self {
            Self::Smooth(smooth) => smooth.check(),
            Self::Rough(rough) => rough.check(),
        }
    }

    fn effect(&self) -> Option<Effect> {
        match self {
            Self::Smooth(smooth) => smooth.effect(),
            Self::Rough(rough) => rough.effect(),
        }
    }

    fn reflects(&self) -> bool {
        match self {
            Self::Smooth(smooth) => smooth.reflects(),
            Self::Rough(rough) => rough.reflects(),
        }
    }
}
