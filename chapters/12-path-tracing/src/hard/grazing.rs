//! PT-07 and PT-08: directions that all but lie in the surface.

use common::film::Color;
use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{Vec2, Vec3};
use monte_carlo::frame::Frame;
use monte_carlo::warp::hemisphere;
use ray_casting::shape::Hit;

use super::{CHAPTER, direction};
use crate::bsdf::{Bsdf, BsdfSample};
use crate::lambert::Lambert;
use crate::naive;
use crate::random::Random;
use crate::space::Met;
use crate::vertex::Vertex;

/// PT-07: a matte surface's weight is its reflectance, to the bit.
pub(super) const WEIGHT: Case = Case {
    id: "PT-07",
    chapter: CHAPTER,
    input: "a matte surface's weight f cos / pdf, at the disk's rim",
    most: UNLIMITED,
    naive_fails: |trial| {
        let Grazing { frame, u, reflectance, .. } = Grazing::new(trial);
        let local = naive::cosine_direction(u);
        !is_near(naive::weight(reflectance, &frame, local), reflectance)
    },
    robust_fails: |trial| {
        let Grazing { u, reflectance, .. } = Grazing::new(trial);
        let lambert = Lambert { reflectance: Color::splat(reflectance) };
        // What was chosen at the rim has a density, and weighs what it must.
        let rim = hemisphere::cosine(u);
        let pdf = lambert.pdf(Vec3::Z, rim);
        let at_rim = lambert.eval(Vec3::Z, rim).x * rim.z / pdf;
        // What was chosen anywhere weighs that to the bit.
        let outgoing = Vec3::new(0.6, 0.0, if trial.is_multiple_of(2) { 0.8 } else { -0.8 });
        let random = Random::of_trial(1271, trial);
        let bounded = lambert.sample(outgoing, &random).is_some_and(|sample| {
            let density = lambert.pdf(outgoing, sample.incoming);
            sample.weight == lambert.reflectance && sample.pdf == density && density > 0.0
        });
        !(pdf > 0.0 && is_near(at_rim, reflectance) && bounded)
    },
};

/// PT-08: a path never goes on below the surface, and never starts there.
pub(super) const BELOW: Case = Case {
    id: "PT-08",
    chapter: CHAPTER,
    input: "a direction at the disk's rim, turned into the world's axes",
    most: UNLIMITED,
    naive_fails: |trial| {
        let Grazing { frame, u, .. } = Grazing::new(trial);
        let direction = frame.to_world(naive::cosine_direction(u));
        !(exact_height(direction, frame.normal) > 0.0)
    },
    robust_fails: |trial| {
        let grazing = Grazing::new(trial);
        let met = grazing.met();
        let bsdf = Lambert::new(0.5, 0.5, 0.5);
        let (frame, outgoing) = (grazing.frame, Vec3::Z);
        let vertex = Vertex { met: &met, frame, outgoing, bsdf: &bsdf };
        // Ours at the rim goes on; the naive one may be refused, but is never sent below.
        let ours = hemisphere::cosine(grazing.u);
        let falls = |incoming, must_go| {
            let sample = BsdfSample { incoming, weight: Color::ONE, pdf: 1.0, is_delta: false };
            vertex.leave(&sample).map_or(must_go, |(ray, _)| {
                let start = exact_height(ray.origin, frame.normal) - grazing.height();
                !(exact_height(ray.direction, frame.normal) > 0.0 && start > 0.0)
            })
        };
        falls(ours, true) || falls(naive::cosine_direction(grazing.u), false)
    },
};

/// A surface somewhere, and a point of the disk's rim.
struct Grazing {
    frame: Frame,
    point: Vec3,
    u: Vec2,
    reflectance: f32,
}

impl Grazing {
    fn new(trial: u64) -> Self {
        let mut stream = Stream::of_trial(1270, trial);
        let frame = Frame::around(direction(&mut stream));
        let mut along = || stream.between(-100.0, 100.0);
        let point = Vec3::new(along(), along(), along());
        // The left edge of the square, which becomes the rim, or a float or two from it.
        let edge = (stream.bits() % 4) as f32 * f32::EPSILON / 2.0;
        let u = Vec2::new(edge, stream.uniform());
        Self { frame, point, u, reflectance: stream.between(0.05, 1.0) }
    }

    fn height(&self) -> f64 {
        exact_height(self.point, self.frame.normal)
    }

    fn met(&self) -> Met {
        let (point, normal) = (self.point, self.frame.normal);
        let error = 1e-5 * Vec3::ONE;
        let hit = Hit { t: 1.0, point, error, geometric: normal, normal, uv: Vec2::ZERO };
        Met { hit, piece: 0, owner: 0 }
    }
}

/// The height over the surface, in `f64`: products of `f32` are exact there.
fn exact_height(vector: Vec3, normal: Vec3) -> f64 {
    vector.as_dvec3().dot(normal.as_dvec3())
}

fn is_near(weight: f32, reflectance: f32) -> bool {
    (weight - reflectance).abs() <= 1e-5 * reflectance
}
