//! Loops that were each written for one kind of scene: what the integrator has to be as fast as.

use common::film::Color;
use common::tally::Off;
use glam::DVec3;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;
use shadows::spawn::spawn;

use crate::bend::{Incidence, precise};
use crate::dielectric;
use crate::glass::Surface;
use crate::inside::Inside;
use crate::interface::Interface;
use crate::passage::{Met, next};
use crate::scenes::Stage;
use crate::shade::{Lit, Seen};

/// Lamps, shadows and paints; nothing reflects.
pub(super) fn matte(stage: &Stage, ray: &Ray) -> Color {
    let scene = &stage.scene;
    let Some(found) = scene.nearest(ray, &mut Off) else { return scene.background };
    let Surface::Opaque(material) = &found.object.material else { return Color::ZERO };
    let inside = Inside::default();
    let seen = Seen { scene, hit: &found.hit, toward_eye: -ray.direction, inside, unseen: false };
    let sent = Lit::<true, true, true>::sent(&seen, material, &mut Off);
    sent.ambient + sent.lamps
}

/// Glass and matte surfaces; both rays are followed, the lesser one first.
pub(super) fn glass(stage: &Stage, ray: &Ray) -> Color {
    let scene = &stage.scene;
    let mut sum = DVec3::ZERO;
    let mut waiting = vec![Part {
        ray: *ray,
        direction: precise(ray.direction),
        inside: stage.around_eye,
        throughput: 1.0,
        depth: 0,
    }];
    while let Some(part) = waiting.pop() {
        match next(scene, &part.ray, part.inside, &mut Off) {
            None => sum += part.throughput * scene.background.as_dvec3(),
            Some(Met::Interface { hit, interface, sides }) => {
                let [first, second] = part.split(&hit, &interface, sides);
                let swap = second.throughput > first.throughput;
                let [last, next] = if swap { [second, first] } else { [first, second] };
                waiting.extend([last, next].into_iter().filter(Part::counts));
            }
            Some(Met::Surface { hit, surface: Surface::Opaque(material), inside }) => {
                let toward_eye = -part.ray.direction;
                let seen = Seen { scene, hit: &hit, toward_eye, inside, unseen: false };
                let sent = Lit::<true, true, true>::sent(&seen, material, &mut Off);
                sum += part.throughput * (sent.ambient + sent.lamps).as_dvec3();
            }
            Some(Met::Surface { .. }) => (),
        }
    }
    sum.as_vec3()
}

/// A ray that is still to be followed.
struct Part {
    ray: Ray,
    direction: DVec3,
    inside: Inside,
    throughput: f64,
    depth: u32,
}

impl Part {
    /// What an interface reflects, and what it lets through.
    fn split(&self, hit: &Hit, interface: &Interface, [near, far]: [Inside; 2]) -> [Self; 2] {
        let incidence = Incidence::new(self.direction, hit.normal);
        let cosine = interface.far_cosine(incidence.cosine);
        let part = |cosine| dielectric::between(interface, incidence.cosine, cosine) as f32;
        let reflected = cosine.map_or(1.0, part);
        let through = incidence.refracted(interface, cosine.unwrap_or(0.0));
        [
            self.next(hit, incidence.reflected(), incidence.normal, near, reflected),
            self.next(hit, through, -incidence.normal, far, 1.0 - reflected),
        ]
    }

    fn next(&self, hit: &Hit, direction: DVec3, side: DVec3, inside: Inside, weight: f32) -> Self {
        let ray = Ray { origin: spawn(hit, side.as_vec3()), direction: direction.as_vec3() };
        let throughput = self.throughput * f64::from(weight);
        Self { ray, direction, inside, throughput, depth: self.depth + 1 }
    }

    fn counts(&self) -> bool {
        self.depth <= 5 && self.throughput > f64::from(0.001_f32)
    }
}
