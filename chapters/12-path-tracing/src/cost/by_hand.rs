//! The path tracer as one would write it for matte scenes with lamps alone.

use common::film::Color;
use common::sampler::Sampler;
use common::tally::Off;
use monte_carlo::frame::Frame;
use monte_carlo::warp::hemisphere;
use ray_casting::ray::Ray;
use shadows::spawn::spawn;

use crate::lambert::Lambert;
use crate::random::{DIRECTION, Random};
use crate::world::World;

/// The radiance that comes back along `ray`.
pub(super) fn matte(world: &World<Lambert>, ray: Ray, depth: u32, sampler: &Sampler) -> Color {
    let (mut ray, mut radiance, mut throughput) = (ray, Color::ZERO, Color::ONE);
    for bounce in 0..=depth {
        let Some(met) = world.space.nearest(&ray, &mut Off) else { break };
        let surface = &world.surfaces[met.owner as usize];
        let frame = Frame::around(met.hit.normal);
        let outgoing = frame.to_local(-ray.direction);
        if surface.emission.glows() {
            radiance += throughput * surface.emission.towards(outgoing.z);
        }
        let reflectance = surface.bsdf.reflectance;
        if bounce == depth || reflectance == Color::ZERO {
            break;
        }
        throughput *= reflectance;
        let up = hemisphere::cosine(Random::at(sampler, bounce + 1).pair(DIRECTION));
        let direction = frame.to_world(up.with_z(up.z.copysign(outgoing.z)));
        let direction = direction / direction.length();
        ray = Ray { origin: spawn(&met.hit, direction), direction };
    }
    radiance
}
