//! Following many directions from each surface, as the rendering equation seems to ask.

use common::film::Color;
use common::sampler::{Purpose, Sampler};
use common::tally::Tally;
use ray_casting::ray::Ray;

use crate::bsdf::Bsdf;
use crate::random::Random;
use crate::tracer::BOUNCES;
use crate::vertex::Vertex;
use crate::world::World;

// ANCHOR: branching
/// An estimator that sends several rays from every surface, and as many from each surface they meet.
#[derive(Clone, Debug)]
pub struct Branching<'a, B> {
    /// The scene.
    pub world: &'a World<'a, B>,
    /// How many directions are followed from each surface, at least 1.
    pub directions: u32,
    /// The most surfaces a path may leave.
    pub depth: u32,
}

impl<B: Bsdf> Branching<'_, B> {
    /// An estimate of the radiance that comes back along `ray`, which met `bounce` surfaces before.
    /// `drawn` counts the directions so far: each has random numbers of its own.
    fn seen<T: Tally>(
        &self,
        ray: &Ray,
        bounce: u32,
        drawn: &mut u32,
        sampler: &Sampler,
        tally: &mut T,
    ) -> Color {
        let Some(met) = self.world.space.nearest(ray, tally) else { return self.world.sky };
        let surface = &self.world.surfaces[met.owner as usize];
        let vertex = Vertex::new(ray, &met, &surface.bsdf);
        let emitted = surface.emission.towards(vertex.outgoing.z);
        if bounce == self.depth {
            return emitted;
        }
        let mut sum = Color::ZERO;
        for _ in 0..self.directions {
            *drawn += 1;
            let random = of_direction(sampler, *drawn);
            let Some(sample) = surface.bsdf.sample(vertex.outgoing, &random) else { continue };
            let Some((onward, _)) = vertex.leave(&sample) else { continue };
            tally.count(BOUNCES, 1);
            sum += sample.weight * self.seen(&onward, bounce + 1, drawn, sampler, tally);
        }
        emitted + sum / self.directions as f32
    }
}
// ANCHOR_END: branching

impl<B: Bsdf> Branching<'_, B> {
    /// An estimate of the radiance that comes back along the camera's `ray`.
    pub fn radiance<T: Tally>(&self, ray: Ray, sampler: &Sampler, tally: &mut T) -> Color {
        self.seen(&ray, 0, &mut 0, sampler, tally)
    }
}

/// The random numbers of direction number `drawn` of a tree. There may be thousands of them, more than
/// a path has bounces, so each is an experiment of its own.
fn of_direction(sampler: &Sampler, drawn: u32) -> Random {
    const TREE: Purpose = Purpose::named("direction of a tree");
    let mut stream = sampler.stream(drawn, TREE);
    Random::of_trial(u64::from(stream.bits()), u64::from(stream.bits()))
}

/// How many rays leave surfaces for one ray of the camera, where no path ends early:
/// n + n² + … + nᵈ for n directions and depth d. The largest number there is, where it is more.
pub fn rays(directions: u32, depth: u32) -> u64 {
    let level = |depth| u64::from(directions).saturating_pow(depth);
    (1..=depth).fold(0, |sum: u64, depth| sum.saturating_add(level(depth)))
}

#[cfg(test)]
mod tests {
    use common::sampler::Sampler;
    use common::stats::estimate::{Estimate, z_test};
    use common::stats::running::Running;
    use common::tally::{Counts, Off};
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::{Branching, rays};
    use crate::furnace;
    use crate::stage::Stage;
    use crate::tracer::BOUNCES;

    const RAY: Ray = Ray { origin: Vec3::new(1.5, 0.25, -0.125), direction: Vec3::X };

    #[test]
    fn the_page_s_worked_number() {
        assert_eq!(rays(4, 5), 4 + 16 + 64 + 256 + 1024);
        assert_eq!(rays(1, 5), 5);
        assert_eq!(rays(100, 100), u64::MAX);
    }

    #[test]
    fn so_many_rays_leave_surfaces() {
        let stage = Stage::new(&furnace::cube(0.5)).expect("sound");
        let world = stage.world();
        for (directions, depth) in [(1, 7), (3, 4), (5, 0)] {
            let mut counts = Counts::default();
            let sampler = Sampler::new(1, 0, 0, 1);
            let branching = Branching { world: &world, directions, depth };
            let ray = Ray { origin: Vec3::new(0.1, 0.2, 0.3), direction: Vec3::NEG_Z };
            let found = f64::from(branching.radiance(ray, &sampler, &mut counts).x);
            assert!((found - furnace::radiance(0.5, depth)).abs() < 1e-5);
            assert_eq!(counts.of(BOUNCES), rays(directions, depth));
        }
    }

    #[test]
    fn every_number_of_directions_has_the_same_mean() {
        let stage = Stage::new(&furnace::shell(0.8)).expect("sound");
        let world = stage.world();
        let exact = Estimate::exact(furnace::shell_radiance(0.8, 4));
        for directions in [1, 2, 5] {
            let branching = Branching { world: &world, directions, depth: 4 };
            let of = |trial| {
                let sampler = Sampler::new(122, trial, 0, 1);
                f64::from(branching.radiance(RAY, &sampler, &mut Off).y)
            };
            let samples: Running = (0..4000).map(of).collect();
            let estimate = Estimate::of(&samples).expect("many");
            let test = z_test(&estimate, &exact);
            assert!(test.p_value > 1e-5, "{directions}: {estimate:?}, {test:?}");
        }
    }
}
