//! Rough glass.

use common::film::Color;
use common::plan::Effect;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::bsdf::{Bsdf, BsdfSample, Material, MaterialError};
use path_tracing::glass::Glass;
use path_tracing::lambert::same_side;
use path_tracing::random::{DIRECTION, LOBE, Random};

use crate::conductor::{check_roughness, reflected_density};
use crate::facets::{Facets, half, reflected, upright};
use crate::passage::Side;

// ANCHOR: dielectric
/// The surface of a body of frosted glass: outside is air.
///
/// Walter, Marschner, Li and Torrance, "Microfacet models for refraction through rough surfaces"
/// (2007). What a path carries is radiance divided by the square of the index around it, as in
/// chapter 7: their equation 21 times (n' / n)², n on the side of `outgoing` and n' on that of
/// `incoming`. So a refracted path keeps what it carries, and it is this function over n'² that is
/// the same in both directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoughDielectric {
    /// The glass's index of refraction.
    pub index: Index,
    /// Its surface.
    pub facets: Facets,
}
// ANCHOR_END: dielectric

impl Bsdf for RoughDielectric {
    #[inline]
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        if self.is_smooth() {
            return Color::ZERO;
        }
        let value = if same_side(outgoing, incoming) {
            self.eval_reflected(outgoing, incoming)
        } else {
            self.eval_refracted(outgoing, incoming)
        };
        Color::splat(value.unwrap_or(0.0))
    }

    #[inline]
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        if self.is_smooth() {
            return 0.0;
        }
        let density = if same_side(outgoing, incoming) {
            self.density_reflected(outgoing, incoming)
        } else {
            self.density_refracted(outgoing, incoming)
        };
        density.unwrap_or(0.0)
    }

    /// A facet that is seen, and one of the two ways there, each as often as it has light.
    #[inline]
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        if self.is_smooth() {
            return Glass { index: self.index }.sample(outgoing, random);
        }
        let (side, up) = (self.side(outgoing), upright(outgoing));
        let normal = self.facets.normal(up, random.pair(DIRECTION))?;
        let through = side.refracted(up, normal);
        let reflectance = through.map_or(1.0, |(_, reflectance)| reflectance);
        let through = through.filter(|_| random.number(LOBE) >= reflectance);
        let (incoming, weight, pdf) = match through {
            Some((incoming, _)) => {
                let passage = side.passage(up, incoming)?;
                let visibility = self.facets.apart(up, upright(incoming));
                let weight = self.facets.weight(up, upright(incoming), normal, visibility);
                let density = passage.density(&self.facets, &side, up);
                (incoming, weight, (1.0 - reflectance) * density)
            }
            None => {
                let incoming = reflected(up, normal);
                if !same_side(up, incoming) {
                    return None;
                }
                let visibility = self.facets.visibility(up, incoming);
                let weight = self.facets.weight(up, incoming, normal, visibility);
                let density = reflected_density(&self.facets, up, normal);
                (incoming, weight, reflectance * density)
            }
        };
        let incoming = incoming.with_z(incoming.z * 1f32.copysign(outgoing.z));
        Some(BsdfSample { incoming, weight: Color::splat(weight), pdf, is_delta: false })
    }

    #[inline]
    fn spreads(&self) -> bool {
        !self.is_smooth()
    }
}

impl RoughDielectric {
    /// Whether it counts as clear glass: where its facets are level, and where it bends light so
    /// little that what goes through keeps its direction all but exactly.
    #[inline]
    pub fn is_smooth(&self) -> bool {
        let alpha = self.facets.ggx.alpha;
        let bent = alpha * (self.index.number() as f32 - 1.0).abs();
        self.facets.ggx.is_smooth() || bent < Self::LEAST_BENT
    }

    /// The narrowest spread of refracted light, in radians, that directions of 24-bit numbers can
    /// tell.
    pub const LEAST_BENT: f32 = 1e-4;

    #[inline]
    fn side(&self, outgoing: Vec3) -> Side {
        Side::of(self.index, outgoing)
    }

    /// F D G₂ / (4 z z').
    #[inline]
    fn eval_reflected(&self, outgoing: Vec3, incoming: Vec3) -> Option<f32> {
        let (side, out, into) = (self.side(outgoing), upright(outgoing), upright(incoming));
        let normal = half(out, into)?;
        let visibility = self.facets.visibility(out, into);
        Some(side.reflectance(out.dot(normal)) * self.facets.ggx.density(normal) * visibility)
    }

    #[inline]
    fn density_reflected(&self, outgoing: Vec3, incoming: Vec3) -> Option<f32> {
        let (side, out) = (self.side(outgoing), upright(outgoing));
        let normal = half(out, upright(incoming))?;
        let density = reflected_density(&self.facets, out, normal);
        Some(side.reflectance(out.dot(normal)) * density)
    }

    // ANCHOR: refracted
    /// (1 - F) D G₁ G₁ |outgoing · h| |incoming · h| (n' / n)² / (z z' |outgoing + (n' / n) incoming|²),
    /// for the normal h of the facets that refract one to the other.
    ///
    /// Which of the facets are seen from above and lit from below has little to do with each other:
    /// a facet high up is seen the better and lit the less. Walter's product takes them as independent.
    #[inline]
    fn eval_refracted(&self, outgoing: Vec3, incoming: Vec3) -> Option<f32> {
        let (side, out) = (self.side(outgoing), upright(outgoing));
        let passage = side.passage(out, incoming.with_z(-incoming.z.abs()))?;
        let through = passage.through(&side);
        let visibility = 4.0 * self.facets.apart(out, upright(incoming));
        let density = self.facets.ggx.density(passage.normal);
        Some(through * density * visibility * passage.facing * passage.stretched(&side))
    }
    // ANCHOR_END: refracted

    #[inline]
    fn density_refracted(&self, outgoing: Vec3, incoming: Vec3) -> Option<f32> {
        let (side, out) = (self.side(outgoing), upright(outgoing));
        let passage = side.passage(out, incoming.with_z(-incoming.z.abs()))?;
        let through = passage.through(&side);
        Some(through * passage.density(&self.facets, &side, out))
    }
}

impl Material for RoughDielectric {
    fn check(&self) -> Result<(), MaterialError> {
        check_roughness(self.facets.ggx.alpha)
    }

    fn effect(&self) -> Option<Effect> {
        Some(if self.is_smooth() { Effect::Refraction } else { Effect::GlossyReflection })
    }

    fn reflects(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use fresnel::index::Index;
    use glam::Vec3;
    use path_tracing::bsdf::Bsdf;
    use path_tracing::glass::Glass;
    use path_tracing::random::Random;

    use super::RoughDielectric;
    use crate::facets::Facets;

    #[test]
    fn by_hand() {
        let glass = RoughDielectric { index: Index::GLASS, facets: Facets::new(0.5) };
        let through = glass.eval(Vec3::Z, Vec3::NEG_Z).x;
        assert!((through - 11.000_79).abs() < 1e-3, "{through}");
        // Out again: a density in the air has 2.25 times the steradians.
        let back = glass.eval(Vec3::NEG_Z, Vec3::Z).x;
        assert!((through / back - 2.25).abs() < 1e-4, "{back}");
    }

    #[test]
    fn glass_that_hardly_bends_light_is_clear() {
        for (index, alpha) in [(1.0, 1.0), (1.0001, 0.9), (1.5, 0.0), (1.5, 1e-8)] {
            let index = Index::new(index).expect("an index");
            let glass = RoughDielectric { index, facets: Facets::new(alpha) };
            let (outgoing, random) = (Vec3::new(0.6, 0.0, 0.8), Random::of_trial(1510, 0));
            assert_eq!(glass.sample(outgoing, &random), Glass { index }.sample(outgoing, &random));
            assert!(!glass.spreads() && glass.eval(outgoing, -outgoing).x == 0.0);
        }
    }
}
