//! The light that sixteen paths may get from lamps.

use common::tally::Tally;
use glam::{Vec2, Vec3};
use light_sampling::by_light::LIGHT_SAMPLES;
use light_sampling::lamp::by_area;
use light_sampling::lights::LAMP_POINT;
use monte_carlo::warp::triangle::barycentric;
use path_tracing::bsdf::Bsdf;
use path_tracing::part::Emission;
use shadows::visibility::between_hits;
use triangles::bundle::{RAYS, Vectors};
use triangles::surface::place;

use super::column::is_some;
use super::paths::Paths;
use super::room::Room;
use super::vertices::{Vertices, on};
use super::waiting::{Sight, Waiting};

/// Light that comes from lamps, if nothing is in its way.
pub(super) struct Sights {
    /// Whether there is a point of a lamp.
    sampled: [bool; RAYS],
    /// Whether it can bring any light.
    used: [bool; RAYS],
    origin: Vectors,
    way: Vectors,
    light: Vectors,
}

impl Sights {
    /// A point of a lamp for each path, and the way there.
    #[inline(always)]
    pub(super) fn new(paths: &Paths, room: &Room, vertices: &Vertices) -> Self {
        let u = paths.pairs(LAMP_POINT);
        let chosen = room.lamps.choose(&u[0]);
        let mut sights = Self {
            sampled: [false; RAYS],
            used: [false; RAYS],
            origin: Vectors::ZERO,
            way: Vectors::ZERO,
            light: Vectors::ZERO,
        };
        let lamps = &chosen.triangle;
        let [a, b, c] = &room.corners(lamps);
        let (normal, radiance) = (room.normal.of(lamps), room.radiance.of(lamps));
        let mut both_sides = [false; RAYS];
        for path in 0..RAYS {
            both_sides[path] = room.emission(lamps[path]).both_sides;
        }
        for path in 0..RAYS {
            let weights = barycentric(Vec2::new(chosen.rest[path], u[1][path]));
            let placed = place([a.at(path), b.at(path), c.at(path)], weights);
            let at = on(placed, normal.at(path));
            let hit = vertices.hit(path);
            let point = by_area(hit.point, at, chosen.area[path]);
            let is_point = point.is_some();
            let direction = point.map_or(Vec3::ZERO, |point| point.direction);
            let pdf = chosen.probability[path] * point.map_or(1.0, |point| point.pdf);
            let emission = Emission { radiance: radiance.at(path), both_sides: both_sides[path] };
            let radiance = emission.towards(-direction.dot(at.geometric));
            let incoming = vertices.frame(path).to_local(direction);
            let outgoing = Vec3::new(0.0, 0.0, vertices.height[path]);
            let part = vertices.material(path).eval(outgoing, incoming) * incoming.z.abs();
            let ray = between_hits(&hit, &at);
            let sampled = vertices.spreads[path] & is_point & is_some(radiance);
            sights.sampled[path] = sampled;
            sights.used[path] = sampled & is_some(part);
            sights.origin.set(path, ray.origin);
            sights.way.set(path, ray.direction);
            let light = part * radiance / pdf;
            sights.light.set(path, paths.throughput.at(path) * light);
        }
        sights
    }

    /// Adds those that may bring light to what waits.
    #[inline(always)]
    pub(super) fn wait<T: Tally>(
        &self,
        sample: &[usize; RAYS],
        waiting: &mut Waiting,
        tally: &mut T,
    ) {
        let mut sampled = 0;
        for path in 0..RAYS {
            sampled += u64::from(self.sampled[path]);
        }
        tally.count(LIGHT_SAMPLES, sampled);
        for path in 0..RAYS {
            if self.used[path] {
                waiting.push(Sight {
                    sample: sample[path],
                    origin: self.origin.at(path),
                    way: self.way.at(path),
                    light: self.light.at(path),
                });
            }
        }
    }
}
