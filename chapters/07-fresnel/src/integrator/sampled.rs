//! What becomes of one sample's rays where they meet something.

use common::film::Color;
use common::sampler::Sampler;
use common::tally::{Event, Tally};
use ray_casting::shape::Hit;
use whitted::scatter::{Branch, Scatter, Scattered};
use whitted::world::detailed;

use super::{Integrator, REFLECTED, REFRACTED, TOTAL_REFLECTIONS};
use crate::bend::{Bent, Refracted, bent};
use crate::dielectric;
use crate::inside::Inside;
use crate::interface::Interface;
use crate::passage::{Met, next};
use crate::path::{Branching, Formula, Path, WHICH_WAY};
use crate::schlick;
use crate::shade::Lit;

/// An integrator for the rays of one sample, with its random numbers. They are not in the [`Path`]: that
/// is copied at every surface, and a smaller one is copied faster.
pub(super) struct Sampled<'a, L, const MIRRORS: bool, const GLASS: bool> {
    pub(super) integrator: &'a Integrator<'a, L, MIRRORS, GLASS>,
    pub(super) sampler: &'a Sampler,
}

impl<L, const MIRRORS: bool, const GLASS: bool> Sampled<'_, L, MIRRORS, GLASS> {
    // ANCHOR: split
    /// The two rays that leave an interface: what it reflects, and what it lets through.
    ///
    /// What is followed is radiance divided by n². Refraction changes radiance by just that
    /// square, so nothing has to be scaled here: the parts add up to 1.
    #[inline]
    fn split<T: Tally>(
        &self,
        path: &Path,
        hit: &Hit,
        interface: &Interface,
        [near, far]: &[Inside; 2],
        tally: &mut T,
    ) -> [Option<Branch<Path>>; 2] {
        let Bent { incidence, reflected, refracted, side } = bent(path.direction, hit, interface);
        let reflected = path.at(hit, reflected, side, *near);
        let Some(Refracted { cosine, direction }) = refracted else {
            tally.count(TOTAL_REFLECTIONS, 1);
            return [branch(reflected, 1.0, &REFLECTED), None];
        };
        let refracted = path.at(hit, direction, -side, *far);
        let part = match self.integrator.formula {
            Formula::Exact => dielectric::between(interface, incidence.cosine, cosine),
            Formula::Schlick => schlick::between(interface, incidence.cosine, cosine),
        } as f32;
        match self.integrator.branching {
            Branching::Both => {
                [branch(reflected, part, &REFLECTED), branch(refracted, 1.0 - part, &REFRACTED)]
            }
            // Chosen as often as it counts, it counts in full.
            Branching::One if self.chance(path) < part => {
                [branch(reflected, 1.0, &REFLECTED), None]
            }
            Branching::One => [branch(refracted, 1.0, &REFRACTED), None],
        }
    }
    // ANCHOR_END: split

    /// The random number that chooses between reflection and refraction here, in [0, 1).
    fn chance(&self, path: &Path) -> f32 {
        self.sampler.stream(path.bounce, WHICH_WAY).uniform()
    }
}

fn branch(ray: Path, part: f32, event: &'static Event) -> Option<Branch<Path>> {
    Some(Branch { ray, weight: Color::splat(part), event })
}

impl<
    const SHADING: bool,
    const DETAILS: bool,
    const SHADOWS: bool,
    const MIRRORS: bool,
    const GLASS: bool,
> Scatter for Sampled<'_, Lit<SHADING, DETAILS, SHADOWS>, MIRRORS, GLASS>
{
    type Ray = Path;

    // ANCHOR: scatter
    #[inline]
    fn scatter<T: Tally>(&self, path: &Path, tally: &mut T) -> Scattered<Path> {
        let integrator = self.integrator;
        if !GLASS {
            let Some(mut found) = integrator.scene.nearest(&path.ray, tally) else {
                return Scattered::only(integrator.background());
            };
            let surface = &found.object.material;
            return integrator.off_surface(path, &mut found.hit, path.inside, surface, tally);
        }
        match &mut next(integrator.scene, &path.ray, path.inside, tally) {
            None => Scattered::only(integrator.background()),
            Some(Met::Interface { hit, interface, sides }) => {
                let hit = detailed::<DETAILS, T>(hit, tally);
                let branches = self.split(path, hit, interface, sides, tally);
                Scattered { light: Color::ZERO, branches }
            }
            Some(Met::Surface { hit, surface, inside }) => {
                integrator.off_surface(path, hit, *inside, surface, tally)
            }
        }
    }
    // ANCHOR_END: scatter
}
