//! WH-03: two media whose indices are equal, or nearly.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{DVec3, Vec3};

use super::{CHAPTER, direction};
use crate::bend::{Incidence, precise};
use crate::dielectric::reflectance;
use crate::index::Index;
use crate::interface::Interface;
use crate::naive;

/// WH-03: equal indices must neither reflect nor bend, and nearly equal ones a little.
pub(super) const MATCHED: Case = Case {
    id: "WH-03",
    chapter: CHAPTER,
    input: "indices that are equal, or differ by 1 to 1000 ulp",
    most: UNLIMITED,
    naive_fails: |trial| {
        let pair = pair(trial);
        let ratio = (pair.near.number() / pair.far.number()) as f32;
        let cosine = -pair.direction.dot(pair.normal);
        let reflected = f64::from(naive::reflectance(ratio, cosine));
        let bent = naive::refract(pair.direction, pair.normal, ratio);
        pair.is_wrong(reflected, bent.map(Vec3::as_dvec3), pair.direction.as_dvec3())
    },
    robust_fails: |trial| {
        let pair = pair(trial);
        let straight = precise(pair.direction);
        let incidence = Incidence::new(straight, pair.normal);
        let interface = Interface::new(pair.near, pair.far);
        let bent = interface
            .far_cosine(incidence.cosine)
            .map(|cosine| incidence.refracted(&interface, cosine));
        pair.is_wrong(reflectance(&interface, incidence.cosine), bent, straight)
    },
};

/// A ray and two media.
struct Pair {
    near: Index,
    far: Index,
    direction: Vec3,
    normal: Vec3,
}

fn pair(trial: u64) -> Pair {
    let mut stream = Stream::of_trial(715, trial);
    let index = stream.between(1.0, 2.5);
    let ulps = if trial.is_multiple_of(2) { 0 } else { 1 + stream.bits() % 1000 };
    let far = f32::from_bits(index.to_bits() + ulps);
    let (direction, normal) = (direction(&mut stream), direction(&mut stream));
    let normal = if direction.dot(normal) > 0.0 { -normal } else { normal };
    let [near, far] = [index, far].map(|number| Index::new(number).unwrap_or(Index::GLASS));
    Pair { near, far, direction, normal }
}

impl Pair {
    /// Equal media: nothing reflected, no bit of the direction changed. Nearly equal ones: what is
    /// reflected is right to 10⁻⁴ of itself.
    fn is_wrong(&self, reflected: f64, bent: Option<DVec3>, straight: DVec3) -> bool {
        if self.near == self.far {
            return !(reflected == 0.0 && bent == Some(straight));
        }
        let right = self.factored(Incidence::new(precise(self.direction), self.normal).cosine);
        !((reflected - right).abs() <= 1e-4 * right)
    }

    /// Fresnel's equations with the difference of the indices factored out, (a - b) as
    /// (a² - b²) / (a + b): nothing cancels, however near the indices are.
    fn factored(&self, cosine: f64) -> f64 {
        let (near, far) = (self.near.number(), self.far.number());
        let ratio = near / far;
        let rest = (far - near) * (far + near) / (far * far);
        let beyond = (rest + ratio * ratio * cosine * cosine).max(0.0).sqrt();
        let (across, within) = (ratio * cosine + beyond, cosine + ratio * beyond);
        let perpendicular = rest / (across * across);
        let squares = cosine * cosine - ratio * ratio * (1.0 - cosine * cosine);
        let parallel = rest * squares / (within * within);
        (perpendicular * perpendicular + parallel * parallel) / 2.0
    }
}
