//! Clear glass in air.

use common::film::Color;
use fresnel::dielectric;
use fresnel::index::Index;
use fresnel::interface::Interface;
use glam::{DVec3, Vec3};

use crate::bsdf::{Bsdf, BsdfSample};
use crate::mirror::mirrored;
use crate::random::{LOBE, Random};

// ANCHOR: glass
/// The surface of a body of glass: outside is air.
///
/// What a path carries is radiance divided by the square of the index around it, as in chapter 7, so
/// refraction changes nothing of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    /// The glass's index of refraction.
    pub index: Index,
}

impl Bsdf for Glass {
    #[inline]
    fn eval(&self, _outgoing: Vec3, _incoming: Vec3) -> Color {
        Color::ZERO
    }

    #[inline]
    fn pdf(&self, _outgoing: Vec3, _incoming: Vec3) -> f32 {
        0.0
    }

    /// One of the two ways, each as often as it has light: so it counts in full.
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        let interface = self.interface(outgoing);
        let cosine = f64::from(outgoing.z.abs()).min(1.0);
        let far_cosine = interface.far_cosine(cosine);
        let reflected = far_cosine.map_or(1.0, |far| dielectric::between(&interface, cosine, far));
        let chosen = far_cosine.filter(|_| f64::from(random.number(LOBE)) >= reflected);
        let (incoming, probability) = match chosen {
            None => (mirrored(outgoing), reflected),
            Some(far) => (refracted(outgoing, &interface, far)?, 1.0 - reflected),
        };
        let pdf = probability as f32;
        Some(BsdfSample { incoming, weight: Color::ONE, pdf, is_delta: true })
    }

    #[inline]
    fn spreads(&self) -> bool {
        false
    }
}
// ANCHOR_END: glass

impl Glass {
    /// The interface as a ray finds it that comes from the side of `outgoing`.
    fn interface(&self, outgoing: Vec3) -> Interface {
        let entering = Interface::new(Index::AIR, self.index);
        if outgoing.z > 0.0 { entering } else { entering.reversed() }
    }
}

/// The direction beyond: Snell's law for what runs along the surface.
fn refracted(outgoing: Vec3, interface: &Interface, far_cosine: f64) -> Option<Vec3> {
    let along = -interface.ratio() * outgoing.as_dvec3().truncate();
    let z = far_cosine.copysign(-f64::from(outgoing.z));
    DVec3::new(along.x, along.y, z).try_normalize().map(|direction| direction.as_vec3())
}
