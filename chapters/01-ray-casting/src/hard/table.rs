//! RC-06: origins inside, in the centre and on the surface, and radii that are no radii.

use common::hard::Case;
use glam::Vec3;

use super::CHAPTER;
use crate::naive::NaiveSphere;
use crate::ray::Ray;
use crate::shape::{Hit, Shape};
use crate::sphere::Sphere;

/// RC-06: a table of answers that are known beforehand.
pub(super) const ORIGINS: Case = Case {
    id: "RC-06",
    chapter: CHAPTER,
    input: "origins in, on and at the centre of spheres; radii 0, -1, NaN",
    most: TABLE.len() as u64,
    naive_fails: |trial| fails(trial, |sphere, ray| NaiveSphere(sphere).hit(ray, f32::INFINITY)),
    robust_fails: |trial| fails(trial, |sphere, ray| sphere.hit(ray, f32::INFINITY)),
};

/// The sphere stands at (2, 3, 5) and every ray runs along x.
struct Entry {
    /// The ray's origin, seen from the centre.
    origin: Vec3,
    radius: f32,
    /// The distance to the first hit.
    t: Option<f32>,
}

const CENTER: Vec3 = Vec3::new(2.0, 3.0, 5.0);

const fn entry(x: f32, y: f32, radius: f32, t: Option<f32>) -> Entry {
    Entry { origin: Vec3::new(x, y, 0.0), radius, t }
}

const TABLE: &[Entry] = &[
    // In the centre, and elsewhere inside.
    entry(0.0, 0.0, 1.0, Some(1.0)),
    entry(0.0, 0.0, 3.0, Some(3.0)),
    entry(-0.0, -0.0, 3.0, Some(3.0)),
    entry(0.5, 0.0, 1.0, Some(0.5)),
    // On the surface: leaving, entering, touching.
    entry(1.0, 0.0, 1.0, None),
    entry(-1.0, 0.0, 1.0, Some(2.0)),
    entry(0.0, 1.0, 1.0, None),
    // Outside: in front, behind, beside.
    entry(-4.0, 0.0, 1.0, Some(3.0)),
    entry(4.0, 0.0, 1.0, None),
    entry(-4.0, 1.5, 1.0, None),
    // Radii that are none.
    entry(0.0, 0.0, 0.0, None),
    entry(-4.0, 0.0, 0.0, None),
    entry(-4.0, 0.0, -1.0, None),
    entry(0.0, 0.0, -1.0, None),
    entry(-4.0, 0.0, f32::NAN, None),
    entry(-4.0, 0.0, f32::INFINITY, None),
    // Origins that are no places.
    entry(f32::NAN, 0.0, 1.0, None),
    entry(f32::NEG_INFINITY, 0.0, 1.0, None),
];

fn fails(trial: u64, hit: fn(Sphere, &Ray) -> Option<Hit>) -> bool {
    let Entry { origin, radius, t } = &TABLE[trial as usize];
    let ray = Ray { origin: CENTER + *origin, direction: Vec3::X };
    let found = hit(Sphere { center: CENTER, radius: *radius }, &ray);
    let good = found.is_none_or(|hit| hit.normal.is_normalized() && hit.uv.is_finite());
    found.map(|hit| hit.t) != *t || !good
}
