//! How the facets of a rough surface lie: the GGX distribution.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3, Vec3Swizzles};
use monte_carlo::warp::disk;

// ANCHOR: ggx
/// The normals of a surface that is made of half an ellipsoid's facets: half a ball, pressed to
/// `alpha` of its height.
///
/// Trowbridge and Reitz, "Average irregularity representation of a rough surface for ray reflection"
/// (1975); the name GGX is Walter, Marschner, Li and Torrance's, "Microfacet models for refraction
/// through rough surfaces" (2007). Directions and normals have length 1, in the surface's own axes,
/// with z the normal of the whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ggx {
    /// The roughness, from 0 to 1: the slope that half of all facets, seen from above, exceed.
    pub alpha: f32,
}
// ANCHOR_END: ggx

impl Ggx {
    /// A surface that is smoother than this counts as perfectly smooth (policy P6): in so narrow a
    /// lobe, the directions of 24-bit numbers are too coarse.
    pub const LEAST: f32 = 1e-3;

    /// Whether its facets all count as level.
    #[inline]
    pub fn is_smooth(&self) -> bool {
        !(self.alpha >= Self::LEAST)
    }

    // ANCHOR: density
    /// D: the area of the facets whose normal is `normal`, for each unit of area of the whole and
    /// each steradian of normals. `normal.z` is at least 0.
    ///
    /// Walter and others (2007), equation 33, is α² / (π cos⁴θ (α² + tan²θ)²). With cos⁴θ inside the
    /// square nothing has to be subtracted from 1 (hard case MF-01).
    #[inline]
    pub fn density(&self, normal: Vec3) -> f32 {
        let across = normal.xy().length_squared();
        let square = self.alpha * self.alpha;
        let spread = across + square * normal.z * normal.z;
        square / (PI * spread * spread)
    }
    // ANCHOR_END: density

    // ANCHOR: masking
    /// √(z² + α²(x² + y²)): how long a direction becomes where the ellipsoid is pressed to a ball.
    #[inline]
    pub fn stretch(&self, direction: Vec3) -> f32 {
        let across = self.alpha * self.alpha * direction.xy().length_squared();
        (direction.z * direction.z + across).sqrt()
    }

    /// G₁: the part that is seen from `direction` of the facets that face it. `direction.z` is above
    /// 0.
    ///
    /// Smith, "Geometrical shadowing of a random rough surface" (1967). With Λ = (stretch / z - 1) / 2
    /// it is 1 / (1 + Λ); this form never divides by z (hard case MF-03).
    #[inline]
    pub fn masking(&self, direction: Vec3) -> f32 {
        2.0 * direction.z / (direction.z + self.stretch(direction))
    }
    // ANCHOR_END: masking

    // ANCHOR: normal
    /// A normal with the density D cosθ: each facet as often as it is large, seen from above.
    ///
    /// Walter and others (2007), equations 35 and 36: tan²θ = α² u / (1 - u).
    #[inline]
    pub fn normal(&self, u: Vec2) -> Vec3 {
        let across = self.alpha * u.x.sqrt() * disk::direction(TAU * u.y);
        across.extend((1.0 - u.x).sqrt()).normalize()
    }
    // ANCHOR_END: normal

    // ANCHOR: visible
    /// A normal with the density [`Ggx::visible_density`]: each facet as often as it is large, seen
    /// from `outgoing`, whose z is at least 0.
    ///
    /// Dupuy and Benyoub, "Sampling visible GGX normals with spherical caps" (2023), listing 3:
    /// pressed to a ball, the facets are met by parallel rays, and what these rays are reflected to is
    /// spread evenly over a cap of the sphere. The normal is half way between.
    #[inline]
    pub fn visible_normal(&self, outgoing: Vec3, u: Vec2) -> Vec3 {
        let stretched = Vec3::new(self.alpha * outgoing.x, self.alpha * outgoing.y, outgoing.z);
        let view = stretched / self.stretch(outgoing);

        // The reflected ray is at the height 1 - below = above - 1, from 1 down to -view.z. All is
        // written so that nothing cancels (hard cases MF-05 and MF-06): 1 - view.z too is a square.
        let below = u.x * (1.0 + view.z);
        let height = (1.0 - u.x) * (1.0 + view.z);
        let above = height + view.xy().length_squared() / (1.0 + view.z);
        let across = (below * above).sqrt() * disk::direction(TAU * u.y) + view.xy();
        (self.alpha * across).extend(height).normalize()
    }

    /// The density of the normals that are seen from `outgoing`, per steradian of normals:
    /// G₁ (outgoing · normal) D / cosθ.
    #[inline]
    pub fn visible_density(&self, outgoing: Vec3, normal: Vec3) -> f32 {
        let facing = outgoing.dot(normal).max(0.0);
        2.0 * facing * self.density(normal) / (outgoing.z + self.stretch(outgoing))
    }
    // ANCHOR_END: visible
}

#[cfg(test)]
mod tests {
    use glam::{Vec2, Vec3};

    use super::Ggx;

    const HALF: Ggx = Ggx { alpha: 0.5 };

    fn is_near(found: f32, expected: f32) -> bool {
        (found - expected).abs() < 1e-5
    }

    #[test]
    fn density_by_hand() {
        assert!(is_near(HALF.density(Vec3::Z), 1.273_24));
        assert!(is_near(HALF.density(Vec3::new(0.6, 0.0, 0.8)), 0.294_295));
    }

    #[test]
    fn masking_by_hand() {
        let slanted = Vec3::new(0.6, 0.0, 0.8);
        assert!(is_near(HALF.stretch(slanted), 0.854_4));
        assert!(is_near(HALF.masking(slanted), 0.967_118));
        assert_eq!(HALF.masking(Vec3::Z), 1.0);
        // Near the horizon it is 2 z / α.
        let grazing = HALF.masking(Vec3::new(1.0, 0.0, 1e-20));
        assert!((grazing / 4e-20 - 1.0).abs() < 1e-6, "{grazing}");
    }

    #[test]
    fn visible_normal_by_hand() {
        let normal = HALF.visible_normal(Vec3::Z, Vec2::new(0.5, 0.0));
        assert!((normal - Vec3::new(0.447_214, 0.0, 0.894_427)).length() < 1e-5, "{normal}");
    }

    #[test]
    fn half_of_all_normals_are_steeper_than_the_roughness() {
        let normal = Ggx { alpha: 0.3 }.normal(Vec2::new(0.5, 0.0));
        assert!(is_near(normal.x / normal.z, 0.3));
    }

    #[test]
    fn below_the_least_roughness_it_is_smooth() {
        for (alpha, smooth) in [(0.0, true), (1e-8, true), (9.9e-4, true), (1e-3, false)] {
            assert_eq!(Ggx { alpha }.is_smooth(), smooth, "{alpha}");
        }
    }
}
