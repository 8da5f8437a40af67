//! The rough materials.

use common::film::Color;
use common::plan::Effect;
use fresnel::conductor::Metal;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::bsdf::{Bsdf, BsdfSample, Material, MaterialError};
use path_tracing::random::Random;

use crate::conductor::RoughConductor;
use crate::dielectric::RoughDielectric;
use crate::facets::Facets;

// ANCHOR: rough
/// A material whose surface is neither perfectly rough nor perfectly smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rough {
    /// Metal.
    Conductor(RoughConductor),
    /// Glass.
    Dielectric(RoughDielectric),
}
// ANCHOR_END: rough

impl Rough {
    /// A metal of this roughness, from 0 to 1.
    pub fn metal(metal: Metal, alpha: f32) -> Self {
        Self::Conductor(RoughConductor { metal, facets: Facets::new(alpha) })
    }

    /// Glass of this index of refraction and roughness, from 0 to 1.
    pub fn glass(index: Index, alpha: f32) -> Self {
        Self::Dielectric(RoughDielectric { index, facets: Facets::new(alpha) })
    }

    /// Its facets.
    pub fn facets_mut(&mut self) -> &mut Facets {
        match self {
            Self::Conductor(conductor) => &mut conductor.facets,
            Self::Dielectric(dielectric) => &mut dielectric.facets,
        }
    }
}

impl Bsdf for Rough {
    #[inline]
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        match self {
            Self::Conductor(conductor) => conductor.eval(outgoing, incoming),
            Self::Dielectric(dielectric) => dielectric.eval(outgoing, incoming),
        }
    }

    #[inline]
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        match self {
            Self::Conductor(conductor) => conductor.pdf(outgoing, incoming),
            Self::Dielectric(dielectric) => dielectric.pdf(outgoing, incoming),
        }
    }

    #[inline]
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        match self {
            Self::Conductor(conductor) => conductor.sample(outgoing, random),
            Self::Dielectric(dielectric) => dielectric.sample(outgoing, random),
        }
    }

    #[inline]
    fn spreads(&self) -> bool {
        match self {
            Self::Conductor(conductor) => conductor.spreads(),
            Self::Dielectric(dielectric) => dielectric.spreads(),
        }
    }
}

impl Material for Rough {
    fn check(&self) -> Result<(), MaterialError> {
        match self {
            Self::Conductor(conductor) => conductor.check(),
            Self::Dielectric(dielectric) => dielectric.check(),
        }
    }

    fn effect(&self) -> Option<Effect> {
        match self {
            Self::Conductor(conductor) => conductor.effect(),
            Self::Dielectric(dielectric) => dielectric.effect(),
        }
    }

    fn reflects(&self) -> bool {
        true
    }
}
