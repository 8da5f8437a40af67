//! and RC-04: vectors of any length, and vectors that nearly agree.

use common::hard::{Case, UNLIMITED};
use common::math::difference_of_products;
use common::sampler::Stream;
use glam::Vec3;

use super::{CHAPTER, U, draw};
use crate::direction::unit;
use crate::double;
use crate::naive::NaiveSphere;
use crate::ray::Ray;
use crate::sphere::Sphere;

/// the squares in a length overflow and vanish.
pub(super) const NORMALIZE: Case = Case {
    id: "X-02",
    chapter: CHAPTER,
    input: "normalize a vector between 10^-37 and 10^37 long",
    most: UNLIMITED,
    naive_fails: |trial| !has_length_1(any_length(trial).normalize()),
    robust_fails: |trial| !unit(any_length(trial)).is_some_and(has_length_1),
};

fn any_length(trial: u64) -> Vec3 {
    let mut stream = Stream::of_trial(102, trial);
    draw::in_cube(&mut stream, 1.0) * draw::decade(&mut stream, -37.0, 37.0)
}

fn has_length_1(direction: Vec3) -> bool {
    (direction.as_dvec3().length() - 1.0).abs() <= 4.0 * U
}

/// two products that nearly agree.
pub(super) const PRODUCTS: Case = Case {
    id: "X-07",
    chapter: CHAPTER,
    input: "a b - c d of products that differ by 5e-7 or less",
    most: UNLIMITED,
    naive_fails: |trial| products_differ(trial, |[a, b, c, d]| a * b - c * d),
    robust_fails: |trial| products_differ(trial, |[a, b, c, d]| difference_of_products(a, b, c, d)),
};

fn products_differ(trial: u64, difference: fn([f32; 4]) -> f32) -> bool {
    let mut stream = Stream::of_trial(107, trial);
    let (a, b) = (stream.between(-3.0, 5.0), stream.between(0.1, 7.0));
    let (c, d) = (a * (1.0 + stream.between(-5e-7, 5e-7)), b);
    // Products of f32 are exact in f64.
    let exact = f64::from(a) * f64::from(b) - f64::from(c) * f64::from(d);
    (f64::from(difference([a, b, c, d])) - exact).abs() > 4.0 * U * exact.abs()
}

/// RC-04: a direction of any length, and a sphere four to six away.
pub(super) const LENGTHS: Case = Case {
    id: "RC-04",
    chapter: CHAPTER,
    input: "a ray whose direction is 10^-37 to 10^37 long",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (sphere, vector) = any_ray(trial);
        let ray = Ray { origin: Vec3::ZERO, direction: vector };
        let t = NaiveSphere(sphere).crossing(&ray).map(|crossing| crossing.enter);
        let length = vector.as_dvec3().length();
        distance_is_wrong(&sphere, vector, t.map(|t| f64::from(t) * length))
    },
    robust_fails: |trial| {
        let (sphere, vector) = any_ray(trial);
        let ray = Ray::new(Vec3::ZERO, vector);
        let t = ray.and_then(|ray| sphere.crossing(&ray)).map(|crossing| crossing.enter);
        distance_is_wrong(&sphere, vector, t.map(f64::from))
    },
};

fn any_ray(trial: u64) -> (Sphere, Vec3) {
    let mut stream = Stream::of_trial(204, trial);
    let center = (draw::direction(&mut stream) * 5.0).as_vec3();
    let aim = center + draw::in_cube(&mut stream, 0.4);
    (Sphere { center, radius: 1.0 }, aim * draw::decade(&mut stream, -37.0, 37.0) / 5.0)
}

fn distance_is_wrong(sphere: &Sphere, vector: Vec3, distance: Option<f64>) -> bool {
    // f64 squares any f32 without overflow.
    let ray = Ray { origin: Vec3::ZERO, direction: vector };
    let exact = double::crossing(sphere, &ray, f64::from(sphere.radius));
    let exact = exact.enter * vector.as_dvec3().length();
    !distance.is_some_and(|distance| (distance - exact).abs() <= 1e-5 * exact)
}
