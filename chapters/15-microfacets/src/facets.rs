//! A surface of facets: which of them are seen, and which one a path meets.

use glam::{Vec2, Vec3};

use crate::ggx::Ggx;

// ANCHOR: facets
/// Facets that lie as GGX says, and two choices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facets {
    /// How they lie.
    pub ggx: Ggx,
    /// How often a facet is both seen and lit.
    pub masking: Masking,
    /// Which facets a path meets.
    pub normals: Normals,
}

/// How often a facet is both seen and lit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Masking {
    /// A facet high up is both, one in a pit neither: 1 / (1 + Λ(outgoing) + Λ(incoming)), Smith's
    /// masking for both, at the same height.
    #[default]
    Correlated,
    /// As if one had nothing to do with the other: the product of both.
    Separable,
}

/// Which facets a path meets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normals {
    /// Those that are seen.
    #[default]
    Visible,
    /// All, as if looked at from above.
    All,
}
// ANCHOR_END: facets

impl Facets {
    /// Facets of this roughness, from 0 to 1: with [`Masking::Correlated`] and
    /// [`Normals::Visible`].
    pub fn new(alpha: f32) -> Self {
        let (masking, normals) = (Masking::default(), Normals::default());
        Self { ggx: Ggx { alpha }, masking, normals }
    }

    // ANCHOR: visibility
    /// G₂ / (4 z z'): the part of the facets that is seen from `outgoing` and lit from `incoming`,
    /// with the cosines of both. Their z is above 0.
    ///
    /// Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs" (Journal of
    /// Computer Graphics Techniques 3(2), 2014), equations 98 and 99.
    #[inline]
    pub fn visibility(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        match self.masking {
            Masking::Separable => self.apart(outgoing, incoming),
            Masking::Correlated => {
                let seen = self.ggx.stretch(outgoing) * incoming.z;
                let lit = self.ggx.stretch(incoming) * outgoing.z;
                0.5 / (seen + lit)
            }
        }
    }

    /// G₁ G₁ / (4 z z'): the same as if one had nothing to do with the other.
    #[inline]
    pub fn apart(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        let sum = |direction: Vec3| direction.z + self.ggx.stretch(direction);
        1.0 / (sum(outgoing) * sum(incoming))
    }
    // ANCHOR_END: visibility

    // ANCHOR: sample
    /// The normal of a facet that a path meets which comes from `outgoing`, z above 0. `None` where
    /// it would meet the facet's back.
    #[inline]
    pub fn normal(&self, outgoing: Vec3, u: Vec2) -> Option<Vec3> {
        let normal = match self.normals {
            Normals::Visible => self.ggx.visible_normal(outgoing, u),
            Normals::All => self.ggx.normal(u),
        };
        (outgoing.dot(normal) > 0.0).then_some(normal)
    }

    /// The density of [`Facets::normal`], per steradian of normals.
    #[inline]
    pub fn density(&self, outgoing: Vec3, normal: Vec3) -> f32 {
        match self.normals {
            Normals::Visible => self.ggx.visible_density(outgoing, normal),
            Normals::All => self.ggx.density(normal) * normal.z,
        }
    }

    /// What remains of a path's light after [`Facets::normal`], for a `visibility` of the two
    /// directions: (outgoing · normal) D G₂ / z, divided by the density.
    ///
    /// For visible normals that is G₂ / G₁, which is never above 1: D cancels, and so does all that
    /// may be huge.
    #[inline]
    pub fn weight(&self, outgoing: Vec3, incoming: Vec3, normal: Vec3, visibility: f32) -> f32 {
        let shared = 2.0 * visibility * incoming.z;
        match self.normals {
            Normals::Visible => (shared * (outgoing.z + self.ggx.stretch(outgoing))).min(1.0),
            Normals::All => 2.0 * shared * outgoing.dot(normal) / normal.z,
        }
    }
    // ANCHOR_END: sample
}

/// The normal half way between two directions: `None` for opposite ones.
#[inline]
pub fn half(outgoing: Vec3, incoming: Vec3) -> Option<Vec3> {
    (outgoing + incoming).try_normalize()
}

/// The direction of light that a facet reflects to `outgoing`.
#[inline]
pub fn reflected(outgoing: Vec3, normal: Vec3) -> Vec3 {
    2.0 * outgoing.dot(normal) * normal - outgoing
}

/// The same direction seen from the other side if it is below: both sides of a surface are alike.
#[inline]
pub fn upright(direction: Vec3) -> Vec3 {
    direction.with_z(direction.z.abs())
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::{Facets, half, reflected};

    #[test]
    fn seen_and_lit_by_hand() {
        let (facets, slanted) = (Facets::new(0.5), Vec3::new(0.6, 0.0, 0.8));
        let over = 4.0 * slanted.z * slanted.z;
        let both = over * facets.visibility(slanted, slanted);
        let apart = over * facets.apart(slanted, slanted);
        assert!((both - 0.936_329).abs() < 1e-5 && (apart - 0.935_317).abs() < 1e-5);
    }

    #[test]
    fn reflection_by_hand() {
        let normal = Vec3::new(0.6, 0.0, 0.8);
        let incoming = reflected(Vec3::Z, normal);
        assert!((incoming - Vec3::new(0.96, 0.0, 0.28)).length() < 1e-6, "{incoming}");
        assert!(half(Vec3::Z, incoming).is_some_and(|half| (half - normal).length() < 1e-6));
        assert_eq!(half(Vec3::X, Vec3::NEG_X), None);
    }
}
