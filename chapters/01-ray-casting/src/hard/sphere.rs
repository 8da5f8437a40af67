//! RC-01, RC-02, RC-03 and RC-10: spheres that are far, huge or near, and points that drift.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{DVec3, Vec3};

use super::{CHAPTER, U, draw};
use crate::crossing::Crossing;
use crate::double;
use crate::naive::NaiveSphere;
use crate::ray::Ray;
use crate::shape::Shape;
use crate::sphere::Sphere;

/// A ray and the sphere it is asked about.
struct Question {
    sphere: Sphere,
    ray: Ray,
}

impl Question {
    fn naive(&self) -> Option<Crossing> {
        NaiveSphere(self.sphere).crossing(&self.ray)
    }

    fn robust(&self) -> Option<Crossing> {
        self.sphere.crossing(&self.ray)
    }
}

/// RC-01: the radius is lost beside the squared distance.
pub(super) const FAR: Case = Case {
    id: "RC-01",
    chapter: CHAPTER,
    input: "a sphere of radius 1 from 10,000 away",
    most: UNLIMITED,
    naive_fails: |trial| {
        let question = far(trial);
        far_is_wrong(&question, question.naive())
    },
    robust_fails: |trial| {
        let question = far(trial);
        far_is_wrong(&question, question.robust())
    },
};

/// A ray that passes the centre within twice the radius.
fn far(trial: u64) -> Question {
    let mut stream = Stream::of_trial(201, trial);
    let way = draw::direction(&mut stream);
    let origin = draw::in_cube(&mut stream, 10.0);
    let center = (origin.as_dvec3() + way * 1e4).as_vec3();
    let beside = draw::across(&mut stream, way) * f64::from(stream.between(0.0, 2.0));
    let direction = center.as_dvec3() + beside - origin.as_dvec3();
    let ray = Ray { origin, direction: direction.normalize().as_vec3() };
    Question { sphere: Sphere { center, radius: 1.0 }, ray }
}

/// An answer is right if it is right for some sphere whose radius differs by less than the spacing
/// of `f32` at this distance, four roundings of the largest number in it.
fn far_is_wrong(question: &Question, found: Option<Crossing>) -> bool {
    let Question { sphere, ray } = question;
    let radius = f64::from(sphere.radius);
    let slack = 4.0 * U * ((ray.origin - sphere.center).as_dvec3().length() + radius);
    let larger = double::crossing(sphere, ray, radius + slack);
    let smaller = double::crossing(sphere, ray, radius - slack);
    match found {
        None => !smaller.enter.is_nan(),
        Some(crossing) => {
            let t = f64::from(crossing.enter);
            let middle = (larger.enter + larger.leave) / 2.0;
            let latest = if smaller.enter.is_nan() { middle } else { smaller.enter };
            !(larger.enter - slack <= t && t <= latest + slack)
        }
    }
}

/// RC-02: the height of the eye is lost beside the radius.
pub(super) const GROUND: Case = Case {
    id: "RC-02",
    chapter: CHAPTER,
    input: "a ground sphere of radius 10^5 to 10^7, seen from 1 to 3 above",
    most: UNLIMITED,
    naive_fails: |trial| {
        let question = ground(trial);
        enters_elsewhere(&question, question.naive(), 1e-4)
    },
    robust_fails: |trial| {
        let question = ground(trial);
        enters_elsewhere(&question, question.robust(), 1e-4)
    },
};

/// The radius and the height are whole numbers, so that their sum is exact: what is not, no formula
/// can put back. The ray falls by more than 1 in 20.
fn ground(trial: u64) -> Question {
    let mut stream = Stream::of_trial(202, trial);
    let radius = draw::decade(&mut stream, 5.0, 7.0).floor();
    let height = draw::whole(&mut stream, 1, 3) as f32;
    let origin = draw::in_cube(&mut stream, 30.0).with_y(height);
    let level = draw::in_cube(&mut stream, 1.0).with_y(0.0);
    let steepness = draw::decade(&mut stream, -1.3, 0.0);
    let direction = level / level.length() - Vec3::Y * steepness;
    let ray = Ray { origin, direction: direction / direction.length() };
    Question { sphere: Sphere { center: Vec3::Y * -radius, radius }, ray }
}

/// Whether the way into the sphere is not where `f64` has it, to this relative error.
fn enters_elsewhere(question: &Question, found: Option<Crossing>, tolerance: f64) -> bool {
    let Question { sphere, ray } = question;
    let exact = double::crossing(sphere, ray, f64::from(sphere.radius)).enter;
    !found.is_some_and(|found| (f64::from(found.enter) - exact).abs() <= tolerance * exact)
}

/// RC-03: two numbers that nearly agree are subtracted where the ray starts near the surface.
pub(super) const NEAR_SURFACE: Case = Case {
    id: "RC-03",
    chapter: CHAPTER,
    input: "a ray towards a sphere from 2^-16 to 2^-4 radii above it",
    most: UNLIMITED,
    naive_fails: |trial| {
        let question = near_surface(trial);
        enters_elsewhere(&question, question.naive(), 32.0 * U)
    },
    robust_fails: |trial| {
        let question = near_surface(trial);
        enters_elsewhere(&question, question.robust(), 32.0 * U)
    },
};

/// On a line through the centre along an axis, where the height above the surface is exact.
fn near_surface(trial: u64) -> Question {
    let mut stream = Stream::of_trial(203, trial);
    let radius = stream.between(0.5, 3.0);
    let axis = Vec3::AXES[(trial % 3) as usize];
    let height = radius / f32::from(1u16 << draw::whole(&mut stream, 4, 15));
    let aside = draw::across(&mut stream, axis.as_dvec3()) * f64::from(stream.between(0.0, 1.5));
    let direction = (aside - axis.as_dvec3()).normalize().as_vec3();
    let ray = Ray { origin: axis * (radius + height), direction };
    Question { sphere: Sphere { center: Vec3::ZERO, radius }, ray }
}

/// RC-10: a point far along a ray has the rounding of its distance.
pub(super) const DRIFT: Case = Case {
    id: "RC-10",
    chapter: CHAPTER,
    input: "the point where a ray from 10^5 away meets a sphere",
    most: UNLIMITED,
    naive_fails: |trial| {
        let question = drifting(trial);
        let hit = question.sphere.hit(&question.ray, f32::INFINITY);
        is_off_surface(&question.sphere, hit.map(|hit| question.ray.at(hit.t)))
    },
    robust_fails: |trial| {
        let question = drifting(trial);
        let hit = question.sphere.hit(&question.ray, f32::INFINITY);
        is_off_surface(&question.sphere, hit.map(|hit| hit.point))
    },
};

fn drifting(trial: u64) -> Question {
    let mut stream = Stream::of_trial(210, trial);
    let sphere =
        Sphere { center: draw::in_cube(&mut stream, 4.0), radius: stream.between(1.0, 2.0) };
    let origin = (draw::direction(&mut stream) * 1e5).as_vec3();
    let aim = sphere.center + draw::in_cube(&mut stream, 0.5);
    let direction: DVec3 = aim.as_dvec3() - origin.as_dvec3();
    Question { sphere, ray: Ray { origin, direction: direction.normalize().as_vec3() } }
}

fn is_off_surface(sphere: &Sphere, point: Option<Vec3>) -> bool {
    let (center, radius) = (sphere.center.as_dvec3(), f64::from(sphere.radius));
    let bound = 4.0 * U * (radius + center.length());
    !point.is_some_and(|point| ((point.as_dvec3() - center).length() - radius).abs() <= bound)
}
