//! WH-09: a liquid that touches its glass, or overlaps it.

use blinn_phong::object::Object;
use blinn_phong::scene::Scene;
use common::film::Color;
use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use common::tally::Off;
use glam::{DVec3, Vec3};
use ray_casting::camera::View;
use ray_casting::plane::Plane;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use shadows::spawn::spawn;

use super::{CHAPTER, direction, index, upon};
use crate::bend::{Incidence, precise};
use crate::glass::{Glass, Surface};
use crate::index::Index;
use crate::inside::Inside;
use crate::interface::Interface;
use crate::passage::{Met, next};

/// WH-09: from air into glass, from glass into liquid, from liquid into air: three interfaces.
pub(super) const TOUCHING: Case = Case {
    id: "WH-09",
    chapter: CHAPTER,
    input: "a liquid that touches its glass, or overlaps it by 2^-1 to 2^-30",
    most: UNLIMITED,
    naive_fails: |trial| Layers::of(trial).is_none_or(|layers| layers.is_wrong(&layers.naive())),
    robust_fails: |trial| Layers::of(trial).is_none_or(|layers| layers.is_wrong(&layers.ours())),
};

/// All that lies between two parallel planes, with normals that point outwards.
struct Between([Plane; 2]);

impl Shape for Between {
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let [front, back] = &self.0;
        let first = front.hit(ray, t_max);
        back.hit(ray, first.map_or(t_max, |hit| hit.t)).or(first)
    }
}

/// Two layers, and a ray that goes through both.
struct Layers {
    scene: Scene<Surface>,
    liquid: Index,
    normal: Vec3,
    ray: Ray,
}

impl Layers {
    fn of(trial: u64) -> Option<Self> {
        let mut stream = Stream::of_trial(718, trial);
        let normal = direction(&mut stream);
        let (glass, liquid) = (index(&mut stream, 1.4, 2.0), index(&mut stream, 1.2, 1.39));
        let scale = [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3][stream.bits() as usize % 7];

        // One trial in two touches; the others overlap by less and less.
        let overlap = match stream.bits() % 60 {
            exponent @ 1..=30 => scale / (1_u64 << exponent) as f32,
            _ => 0.0,
        };
        let somewhere = |stream: &mut Stream, depth: f32| {
            let beside = direction(stream).cross(normal);
            scale * stream.between(-3.0, 3.0) * beside - depth * normal
        };
        let mut layer = |front: f32, back: f32| {
            let front = Plane::new(somewhere(&mut stream, front), normal)?;
            let back = Plane::new(somewhere(&mut stream, back), -normal)?;
            Some(Box::new(Between([front, back])) as Box<dyn Shape>)
        };
        let shapes = [layer(0.0, scale)?, layer(scale - overlap, 3.0 * scale)?];
        let materials = [Glass::new(glass).ranked(1), Glass::new(liquid)].map(Surface::Glass);
        let objects = shapes.into_iter().zip(materials);

        let cosine = f64::from(stream.between(0.05, 1.0));
        let direction = upon(&mut stream, normal, cosine).as_vec3();
        let origin = somewhere(&mut stream, 0.0) - scale * direction;
        let view = View { eye: origin, target: Vec3::ZERO, up: Vec3::Y, vertical_fov: 90.0 };
        let scene = Scene {
            objects: objects.map(|(shape, material)| Object { shape, material }).collect(),
            lights: Vec::new(),
            ambient: Color::ZERO,
            background: Color::ONE,
            view,
        };
        Some(Self { scene, liquid, normal, ray: Ray { origin, direction } })
    }

    /// The directions behind each interface that the ray meets, ten at most.
    fn ours(&self) -> Vec<DVec3> {
        let (mut ray, mut inside) = (self.ray, Inside::default());
        let mut precise = precise(ray.direction);
        let mut directions = Vec::new();
        while let Some(Met::Interface { hit, interface, sides }) =
            next(&self.scene, &ray, inside, &mut Off)
            && directions.len() < 10
        {
            let incidence = Incidence::new(precise, hit.normal);
            let Some(cosine) = interface.far_cosine(incidence.cosine) else { break };
            precise = incidence.refracted(&interface, cosine);
            let origin = spawn(&hit, (-incidence.normal).as_vec3());
            (ray, inside) = (Ray { origin, direction: precise.as_vec3() }, sides[1]);
            directions.push(precise);
        }
        directions
    }

    // ANCHOR: naive
    /// The same for a program that remembers nothing: whatever the ray is in, behind a surface of
    /// glass is air when it leaves, and before it is air when it enters.
    fn naive(&self) -> Vec<DVec3> {
        let mut ray = self.ray;
        let mut directions = Vec::new();
        while let Some(found) = self.scene.nearest(&ray, &mut Off)
            && directions.len() < 10
        {
            let index = found.object.material.glass().map_or(Index::AIR, |glass| glass.index);
            let entering = ray.direction.dot(found.hit.geometric) < 0.0;
            let into = Interface::new(Index::AIR, index);
            let interface = if entering { into } else { into.reversed() };
            let incidence = Incidence::new(precise(ray.direction), found.hit.normal);
            let Some(cosine) = interface.far_cosine(incidence.cosine) else { break };
            let direction = incidence.refracted(&interface, cosine);
            let origin = spawn(&found.hit, direction.as_vec3());
            ray = Ray { origin, direction: direction.as_vec3() };
            directions.push(direction);
        }
        directions
    }
    // ANCHOR_END: naive

    /// There must be three interfaces; in the liquid the sine is the air's divided by the liquid's
    /// index, whatever glass was before it; and behind it all is as before.
    fn is_wrong(&self, directions: &[DVec3]) -> bool {
        let &[_, liquid, air] = directions else { return true };
        let before = precise(self.ray.direction);
        let normal = self.normal.as_dvec3().normalize();
        let across = |direction: DVec3| direction - direction.dot(normal) * normal;
        let bent = across(liquid) * self.liquid.number() - across(before);
        !(bent.length() <= 1e-5 && (air - before).length() <= 1e-5)
    }
}

#[cfg(test)]
mod tests {
    use super::Layers;

    #[test]
    fn two_is_the_liquid_and_three_is_air() {
        let layers = Layers::of(1).expect("planes");
        let directions = layers.ours();
        assert_eq!(directions.len(), 3);
        assert!(!layers.is_wrong(&directions));
        assert!(layers.is_wrong(&directions[..2]), "one interface is missing");
        assert!(layers.is_wrong(&layers.naive()), "the control");
    }
}
