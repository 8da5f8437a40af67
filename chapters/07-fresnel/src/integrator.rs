//! Following light through a scene of mirrors, metal and glass.

use blinn_phong::scene::Scene;
use common::film::Color;
use common::sampler::Sampler;
use common::tally::{Event, Tally};
use glam::DVec3;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;
use whitted::limits::Limits;
use whitted::material::Mirrored;
use whitted::mirror::{self, MIRROR_RAYS};
use whitted::scatter::{Branch, Scattered};
use whitted::world::detailed;

use crate::bend::{Incidence, precise};
use crate::conductor::Metal;
use crate::glass::Surface;
use crate::index::Index;
use crate::inside::Inside;
use crate::passage::index;
use crate::path::{Branching, Formula, Path};
use crate::schlick;
use crate::shade::{Lit, Seen, Sent};

mod sampled;

use sampled::Sampled;

/// Rays that an interface reflects.
pub const REFLECTED: Event = Event::new(7, 0, "reflected_rays");
/// Rays followed through an interface.
pub const REFRACTED: Event = Event::new(7, 1, "refracted_rays");
/// Rays that met an interface and could not pass.
pub const TOTAL_REFLECTIONS: Event = Event::new(7, 2, "total_reflections");

/// A scene, and how light is followed through it.
pub struct Integrator<'a, L, const MIRRORS: bool, const GLASS: bool> {
    /// The scene.
    pub scene: &'a Scene<Surface>,
    /// How much is reflected.
    pub formula: Formula,
    /// What becomes of two rays.
    pub branching: Branching,
    /// The bodies around the eye.
    pub around_eye: Inside,
    /// Whether the scene has glass that may be no interface.
    pub unseen: bool,
    /// What light of lamps is simulated.
    pub lit: L,
}

impl<L, const MIRRORS: bool, const GLASS: bool> Integrator<'_, L, MIRRORS, GLASS> {
    /// The path of a camera ray.
    fn first(&self, ray: Ray) -> Path {
        let direction = if GLASS { precise(ray.direction) } else { DVec3::ZERO };
        Path { ray, direction, inside: self.around_eye, bounce: 0 }
    }

    /// What metal reflects.
    fn off_metal(&self, met: &Place, metal: &Metal) -> Scattered<Path> {
        let near = self.index(met.inside);
        let color = match self.formula {
            Formula::Exact => metal.reflectance(near, met.cosine()),
            Formula::Schlick => metal.schlick(near, met.cosine()),
        };
        Scattered::with(Color::ZERO, self.mirrored(met, color))
    }

    /// The mirror's ray of a surface that returns `color`.
    fn mirrored(&self, met: &Place, color: Color) -> Option<Branch<Path>> {
        if !MIRRORS || color == Color::ZERO {
            return None;
        }
        let Place { path, hit, inside } = *met;
        let ray = mirror::mirrored(&path.ray, hit)?;
        let direction = if GLASS { precise(ray.direction) } else { DVec3::ZERO };
        let path = Path { ray, direction, inside, bounce: path.bounce + 1 };
        Some(Branch { ray: path, weight: color, event: &MIRROR_RAYS })
    }

    fn index(&self, inside: Inside) -> Index {
        if GLASS { index(self.scene, inside) } else { Index::AIR }
    }

    // ANCHOR: seen
    /// What is seen from the eye of light that a surface sends into the medium around it.
    ///
    /// Radiance / n² is what stays on the way, so lamps' light counts (n_eye / n)² times. Light
    /// from everywhere is n² times as strong in the medium as in air, and that cancels.
    fn seen_from_eye(&self, sent: Sent, inside: Inside) -> Color {
        // In air, seen from air, nothing is scaled.
        if !GLASS || (inside.is_air() && self.around_eye.is_air()) {
            return sent.ambient + sent.lamps;
        }
        let [eye, here] = [self.around_eye, inside].map(|inside| self.index(inside).number());
        let (ambient, lamps) = (eye * eye, (eye / here) * (eye / here));
        ambient as f32 * sent.ambient + lamps as f32 * sent.lamps
    }
    // ANCHOR_END: seen
}

/// Where a path meets an opaque surface.
struct Place<'a> {
    path: &'a Path,
    hit: &'a Hit,
    /// The bodies around the surface.
    inside: Inside,
}

impl Place<'_> {
    /// The cosine of the angle at which the path comes.
    fn cosine(&self) -> f64 {
        Incidence::new(precise(self.path.ray.direction), self.hit.normal).cosine
    }
}

impl<
    const SHADING: bool,
    const DETAILS: bool,
    const SHADOWS: bool,
    const MIRRORS: bool,
    const GLASS: bool,
> Integrator<'_, Lit<SHADING, DETAILS, SHADOWS>, MIRRORS, GLASS>
{
    /// What comes back from a surface that ends the path, or mirrors it.
    #[inline]
    fn off_surface<T: Tally>(
        &self,
        path: &Path,
        hit: &mut Hit,
        inside: Inside,
        surface: &Surface,
        tally: &mut T,
    ) -> Scattered<Path> {
        let hit = detailed::<DETAILS, T>(hit, tally);
        let met = Place { path, hit, inside };
        match surface {
            Surface::Opaque(material) => self.off_opaque(&met, material, tally),
            Surface::Polished(material) => self.off_polished(&met, material, tally),
            Surface::Metal(metal) => self.off_metal(&met, metal),
            // Only its interfaces are met, and only where glass is simulated.
            Surface::Glass(_) => Scattered::only(Color::ZERO),
        }
    }

    /// What an opaque surface sends of lamps, and its mirror's ray.
    #[inline]
    fn off_opaque<T: Tally>(
        &self,
        met: &Place,
        material: &Mirrored,
        tally: &mut T,
    ) -> Scattered<Path> {
        let Place { path, hit, inside } = *met;
        let sent = self.sent(&path.ray, hit, inside, material, tally);
        let light = self.seen_from_eye(sent, inside);
        Scattered::with(light, self.mirrored(met, material.mirror))
    }

    /// What an opaque surface sends back along the ray that met it.
    #[inline]
    fn sent<T: Tally>(
        &self,
        ray: &Ray,
        hit: &Hit,
        inside: Inside,
        material: &Mirrored,
        tally: &mut T,
    ) -> Sent {
        let (scene, unseen) = (self.scene, self.unseen);
        let seen = Seen { scene, hit, toward_eye: -ray.direction, inside, unseen };
        Lit::<SHADING, DETAILS, SHADOWS>::sent(&seen, material, tally)
    }

    /// The same for a polished one, which mirrors more the lower the light comes.
    fn off_polished<T: Tally>(
        &self,
        met: &Place,
        material: &Mirrored,
        tally: &mut T,
    ) -> Scattered<Path> {
        let cosine = met.cosine();
        let part = |straight| schlick::polynomial(straight, cosine);
        let mirror = material.mirror.as_dvec3().map(part).as_vec3();
        self.off_opaque(met, &Mirrored { mirror, ..*material }, tally)
    }

    /// The radiance that a camera's ray brings.
    #[inline]
    pub fn radiance<T: Tally>(
        &self,
        limits: &Limits,
        ray: Ray,
        sampler: &Sampler,
        tally: &mut T,
    ) -> Color {
        match MIRRORS || GLASS {
            true => {
                let sampled = Sampled { integrator: self, sampler };
                limits.trace(&sampled, self.first(ray), tally)
            }
            false => self.met_only(&ray, tally),
        }
    }

    /// The same where nothing reflects and nothing is let through: no path is needed for that.
    #[inline]
    fn met_only<T: Tally>(&self, ray: &Ray, tally: &mut T) -> Color {
        let Some(mut found) = self.scene.nearest(ray, tally) else { return self.background() };
        let hit = detailed::<DETAILS, T>(&mut found.hit, tally);
        match &found.object.material {
            Surface::Opaque(material) | Surface::Polished(material) => {
                let sent = self.sent(ray, hit, Inside::default(), material, tally);
                sent.ambient + sent.lamps
            }
            Surface::Metal(_) | Surface::Glass(_) => Color::ZERO,
        }
    }

    /// The radiance behind everything, which is in air.
    fn background(&self) -> Color {
        if !GLASS || self.around_eye.is_air() {
            return self.scene.background;
        }
        let eye = self.index(self.around_eye).number();
        (eye * eye) as f32 * self.scene.background
    }
}

#[cfg(test)]
mod tests;
