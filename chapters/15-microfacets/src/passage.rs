//! Facets that let light through: where it goes, and which of them do it.

use fresnel::dielectric;
use fresnel::index::Index;
use fresnel::interface::Interface;
use glam::Vec3;

use crate::facets::Facets;

/// A surface as a path finds it that comes from `outgoing`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Side {
    pub(crate) interface: Interface,
    /// n' / n.
    pub(crate) ratio: f32,
}

/// Where light goes that a facet lets through.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Passage {
    /// The facet's normal, on the side of `outgoing`.
    pub(crate) normal: Vec3,
    /// outgoing · normal.
    pub(crate) facing: f32,
    /// |incoming · normal|.
    pub(crate) beyond: f32,
    /// |outgoing + (n' / n) incoming|².
    pub(crate) length_squared: f32,
}

impl Passage {
    /// 1 - F, from both cosines: that of one side alone would have no digits near the critical angle.
    #[inline]
    pub(crate) fn through(&self, side: &Side) -> f32 {
        let [near, far] = [self.facing, self.beyond].map(|cosine| f64::from(cosine).min(1.0));
        1.0 - dielectric::between(&side.interface, near, far) as f32
    }

    /// The steradians of normals for each steradian of directions beyond:
    /// (n' / n)² |incoming · h| / |outgoing + (n' / n) incoming|², Walter's equation 17.
    #[inline]
    pub(crate) fn stretched(&self, side: &Side) -> f32 {
        side.ratio * side.ratio * self.beyond / self.length_squared
    }

    /// The density of the direction beyond, per steradian, among what goes through.
    #[inline]
    pub(crate) fn density(&self, facets: &Facets, side: &Side, outgoing: Vec3) -> f32 {
        facets.density(outgoing, self.normal) * self.stretched(side)
    }
}

impl Side {
    /// The surface of a body of this index, as a path finds it that comes from `outgoing`.
    #[inline]
    pub(crate) fn of(index: Index, outgoing: Vec3) -> Self {
        let entering = Interface::new(Index::AIR, index);
        let interface = if outgoing.z > 0.0 { entering } else { entering.reversed() };
        Self { interface, ratio: (1.0 / interface.ratio()) as f32 }
    }

    /// F.
    #[inline]
    pub(crate) fn reflectance(&self, cosine: f32) -> f32 {
        dielectric::reflectance(&self.interface, f64::from(cosine.clamp(0.0, 1.0))) as f32
    }

    // ANCHOR: beyond
    /// Where a facet sends light on to, below the surface, and how much it reflects. `None` where it
    /// reflects all, and where the facet would send it up.
    #[inline]
    pub(crate) fn refracted(&self, outgoing: Vec3, normal: Vec3) -> Option<(Vec3, f32)> {
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
    pub(crate) fn passage(&self, outgoing: Vec3, incoming: Vec3) -> Option<Passage> {
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
