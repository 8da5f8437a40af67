//! Rough glass.

use common::film::Color;
use common::plan::Effect;
use fresnel::dielectric;
use fresnel::index::Index;
use fresnel::interface::Interface;
use glam::Vec3;
use path_tracing::bsdf::{Bsdf, BsdfSample, Material, MaterialError};
use path_tracing::glass::Glass;
use path_tracing::lambert::same_side;
use path_tracing::random::{DIRECTION, LOBE, Random};

use crate::conductor::{check_roughness, reflected_density};
use crate::facets::{Facets, half, reflected, upright};

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

/// A surface as a path finds it that comes from `outgoing`.
#[derive(Clone, Copy, Debug)]
struct Side {
    interface: Interface,
    /// n' / n.
    ratio: f32,
}

/// Where light goes that a facet lets through.
#[derive(Clone, Copy, Debug)]
struct Passage {
    /// The facet's normal, on the side of `outgoing`.
    normal: Vec3,
    /// outgoing · normal.
    facing: f32,
    /// |incoming · normal|.
    beyond: f32,
    /// |outgoing + (n' / n) incoming|².
    length_squared: f32,
}

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
        let entering = Interface::new(Index::AIR, self.index);
        let interface = if outgoing.z > 0.0 { entering } else { entering.reversed() };
        Side { interface, ratio: (1.0 / interface.ratio()) as f32 }
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

impl Passage {
    /// 1 - F, from both cosines: that of one side alone would have no digits near the critical angle.
    #[inline]
    fn through(&self, side: &Side) -> f32 {
        let [near, far] = [self.facing, self.beyond].map(|cosine| f64::from(cosine).min(1.0));
        1.0 - dielectric::between(&side.interface, near, far) as f32
    }

    /// The steradians of normals for each steradian of directions beyond:
    /// (n' / n)² |incoming · h| / |outgoing + (n' / n) incoming|², Walter's equation 17.
    #[inline]
    fn stretched(&self, side: &Side) -> f32 {
        side.ratio * side.ratio * self.beyond / self.length_squared
    }

    /// The density of the direction beyond, per steradian, among what goes through.
    #[inline]
    fn density(&self, facets: &Facets, side: &Side, outgoing: Vec3) -> f32 {
        facets.density(outgoing, self.normal) * self.stretched(side)
    }
}

impl Side {
    /// F.
    #[inline]
    fn reflectance(&self, cosine: f32) -> f32 {
        dielectric::reflectance(&self.interface, f64::from(cosine.clamp(0.0, 1.0))) as f32
    }

    // ANCHOR: beyond
    /// Where a facet sends light on to, below the surface, and how much it reflects. `None` where it
    /// reflects all, and where the facet would send it up.
    #[inline]
    fn refracted(&self, outgoing: Vec3, normal: Vec3) -> Option<(Vec3, f32)> {
        let cosine = f64::from(outgoing.dot(normal)).clamp(0.0, 1.0);
        let far_cosine = self.interface.far_cosine(cosine)?;
        let reflectance = dielectric::between(&self.interface, cosine, far_cosine) as f32;
        let ratio = self.interface.ratio();
        let along = (ratio * cosine - far_cosine) * normal.as_dvec3();
        let incoming = (along - ratio * outgoing.as_dvec3()).try_normalize()?.as_vec3();
        Some((incoming, reflectance))
    }
    // ANCHOR_END: beyond

    /// The facets that refract `incoming`, below the surface, to `outgoing` above it: their normal is
    /// along outgoing + (n' / n) incoming. `None` where they would be met from behind.
    #[inline]
    fn passage(&self, outgoing: Vec3, incoming: Vec3) -> Option<Passage> {
        if !(outgoing.z * incoming.z < 0.0) {
            return None;
        }
        let sum = outgoing + self.ratio * incoming;
        let normal = sum.try_normalize()?;
        let normal = if normal.z < 0.0 { -normal } else { normal };
        let (facing, beyond) = (outgoing.dot(normal), -incoming.dot(normal));
        let length_squared = sum.length_squared();
        let met = facing > 0.0 && beyond > 0.0;
        met.then_some(Passage { normal, facing, beyond, length_squared })
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
