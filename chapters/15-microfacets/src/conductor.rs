//! Rough metal.

use common::film::Color;
use common::plan::Effect;
use fresnel::conductor::Metal;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::bsdf::{Bsdf, BsdfSample, Material, MaterialError};
use path_tracing::lambert::same_side;
use path_tracing::mirror::mirrored;
use path_tracing::random::{DIRECTION, Random};

use crate::facets::{Facets, half, reflected, upright};

// ANCHOR: conductor
/// A metal whose surface is made of small mirrors, on both sides.
///
/// Cook and Torrance, "A reflectance model for computer graphics" (ACM Transactions on Graphics 1(1),
/// 1982). Light that a facet reflects onto another one is lost: it is not followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoughConductor {
    /// The metal.
    pub metal: Metal,
    /// Its surface.
    pub facets: Facets,
}

/// A metal that reflects all light at every angle: its index is 0.
pub const PERFECT: Metal = Metal { index: [0.0; 3], absorption: [0.0; 3] };

impl Bsdf for RoughConductor {
    /// D F G₂ / (4 z z').
    #[inline]
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        let Some(Pair { outgoing, incoming, normal }) = self.between(outgoing, incoming) else {
            return Color::ZERO;
        };
        let visibility = self.facets.visibility(outgoing, incoming);
        self.reflectance(outgoing, normal) * self.facets.ggx.density(normal) * visibility
    }

    /// The density of the normal half way between, over 4 times the cosine at it.
    #[inline]
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        let pair = self.between(outgoing, incoming);
        pair.map_or(0.0, |pair| reflected_density(&self.facets, pair.outgoing, pair.normal))
    }

    #[inline]
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        if self.facets.ggx.is_smooth() {
            let weight = self.reflectance(upright(outgoing), Vec3::Z);
            let incoming = mirrored(outgoing);
            return Some(BsdfSample { incoming, weight, pdf: 1.0, is_delta: true });
        }
        let up = upright(outgoing);
        let normal = self.facets.normal(up, random.pair(DIRECTION))?;
        let incoming = reflected(up, normal);
        // From a facet down into the surface: the light it would have brought was lost on the way.
        if !same_side(up, incoming) {
            return None;
        }
        let visibility = self.facets.visibility(up, incoming);
        let weight = self.facets.weight(up, incoming, normal, visibility);
        let pdf = reflected_density(&self.facets, up, normal);
        let weight = weight * self.reflectance(up, normal);
        let incoming = incoming.with_z(incoming.z.copysign(outgoing.z));
        Some(BsdfSample { incoming, weight, pdf, is_delta: false })
    }

    #[inline]
    fn spreads(&self) -> bool {
        !self.facets.ggx.is_smooth()
    }
}
// ANCHOR_END: conductor

/// Two directions above a surface, and the normal of the facets that reflect one to the other.
#[derive(Clone, Copy, Debug)]
struct Pair {
    outgoing: Vec3,
    incoming: Vec3,
    normal: Vec3,
}

impl RoughConductor {
    /// Both directions seen from above; `None` where no facet reflects one to the other.
    #[inline]
    fn between(&self, outgoing: Vec3, incoming: Vec3) -> Option<Pair> {
        if self.facets.ggx.is_smooth() || !same_side(outgoing, incoming) {
            return None;
        }
        let (outgoing, incoming) = (upright(outgoing), upright(incoming));
        half(outgoing, incoming).map(|normal| Pair { outgoing, incoming, normal })
    }

    /// F of a facet.
    #[inline]
    fn reflectance(&self, outgoing: Vec3, normal: Vec3) -> Color {
        let cosine = f64::from(outgoing.dot(normal).clamp(0.0, 1.0));
        self.metal.reflectance(Index::AIR, cosine)
    }
}

// ANCHOR: jacobian
/// The density of a direction that a facet reflects to `outgoing`, per steradian: that of the normal,
/// divided by 4 (outgoing · normal).
#[inline]
pub fn reflected_density(facets: &Facets, outgoing: Vec3, normal: Vec3) -> f32 {
    let facing = outgoing.dot(normal);
    if facing > 0.0 { facets.density(outgoing, normal) / (4.0 * facing) } else { 0.0 }
}
// ANCHOR_END: jacobian

impl Material for RoughConductor {
    fn check(&self) -> Result<(), MaterialError> {
        let parts = self.metal.index.iter().chain(&self.metal.absorption);
        if !parts.into_iter().all(|part| part.is_finite() && *part >= 0.0) {
            return Err(MaterialError::Reflectance);
        }
        check_roughness(self.facets.ggx.alpha)
    }

    fn effect(&self) -> Option<Effect> {
        let smooth = self.facets.ggx.is_smooth();
        Some(if smooth { Effect::MirrorReflection } else { Effect::GlossyReflection })
    }

    fn reflects(&self) -> bool {
        true
    }
}

/// # Errors
/// For a roughness that is not from 0 to 1.
pub fn check_roughness(alpha: f32) -> Result<(), MaterialError> {
    if (0.0..=1.0).contains(&alpha) { Ok(()) } else { Err(MaterialError::Roughness) }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::FRAC_1_PI;

    use glam::Vec3;
    use path_tracing::bsdf::Bsdf;

    use super::{PERFECT, RoughConductor, reflected_density};
    use crate::facets::Facets;

    #[test]
    fn by_hand() {
        let metal = RoughConductor { metal: PERFECT, facets: Facets::new(0.5) };
        // D is 4/π, and G₂ is 1: the page's 0.318.
        let straight = metal.eval(Vec3::Z, Vec3::Z);
        assert!((straight - FRAC_1_PI).abs().max_element() < 1e-5, "{straight}");
    }

    #[test]
    fn jacobian_by_hand() {
        let (facets, normal) = (Facets::new(0.5), Vec3::new(0.6, 0.0, 0.8));
        let ratio = facets.density(Vec3::Z, normal) / reflected_density(&facets, Vec3::Z, normal);
        assert!((ratio - 3.2).abs() < 1e-5, "{ratio}");
        assert_eq!(reflected_density(&facets, Vec3::NEG_X, normal), 0.0);
    }
}
