//! RC-05: rays that graze a sphere.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::{CHAPTER, U, draw};
use crate::naive::NaiveSphere;
use crate::ray::Ray;
use crate::shape::{Hit, Shape};
use crate::sphere::Sphere;

/// RC-05: within 64 units in the last place of the rim, hit or miss, and with which normal?
pub(super) const RIM: Case = Case {
    id: "RC-05",
    chapter: CHAPTER,
    input: "a ray that passes within 64 ulp of a sphere's rim",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (sphere, ray) = grazing(trial);
        is_wrong(&sphere, &ray, NaiveSphere(sphere).hit(&ray, f32::INFINITY))
    },
    robust_fails: |trial| {
        let (sphere, ray) = grazing(trial);
        is_wrong(&sphere, &ray, sphere.hit(&ray, f32::INFINITY))
    },
};

/// The ray runs along an axis and the centre is the origin, so that nothing is rounded before the
/// formula begins.
fn grazing(trial: u64) -> (Sphere, Ray) {
    let mut stream = Stream::of_trial(205, trial);
    let sphere = Sphere { center: Vec3::ZERO, radius: stream.between(0.5, 2.0) };
    let axis = Vec3::AXES[(trial % 3) as usize];
    let beyond = draw::whole(&mut stream, -64, 64) as f32 * f32::EPSILON;
    let across = draw::across(&mut stream, axis.as_dvec3()).as_vec3();
    let beside = across * (sphere.radius * (1.0 + beyond));
    let origin = beside - beside.dot(axis) * axis + axis * stream.between(3.0, 100.0);
    (sphere, Ray { origin, direction: -axis })
}

/// Four roundings from the rim, hit or miss must be decided right; and a hit's normal must be as
/// nearly at right angles to the ray as it is on the circle: cos² = 1 - (b/r)².
fn is_wrong(sphere: &Sphere, ray: &Ray, found: Option<Hit>) -> bool {
    let origin = ray.origin.as_dvec3();
    let direction = ray.direction.as_dvec3();
    let beside = (origin - origin.dot(direction) * direction).length();
    let beyond = beside / f64::from(sphere.radius) - 1.0;
    match found {
        None => beyond < -4.0 * U,
        Some(hit) => {
            let cosine = hit.normal.as_dvec3().dot(direction);
            let limit = 2.0 * beyond.abs() + 16.0 * U;
            beyond > 4.0 * U || !(cosine * cosine <= limit)
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use crate::ray::Ray;
    use crate::sphere::Sphere;

    /// Across the rim, one float at a time, hits become misses once and for all.
    #[test]
    fn hit_or_miss_changes_once() {
        for (radius, along) in [(1.0, 3.0), (0.7, 50.0), (1.9, 1e4)] {
            let sphere = Sphere { center: Vec3::ZERO, radius };
            let inner = radius.to_bits() - 64;
            let hits: Vec<bool> = (inner..inner + 129)
                .map(|bits| {
                    let origin = Vec3::new(f32::from_bits(bits), 0.0, along);
                    sphere.crossing(&Ray { origin, direction: -Vec3::Z }).is_some()
                })
                .collect();
            let changes = hits.windows(2).filter(|pair| pair[0] != pair[1]).count();
            assert!(hits[0] && !hits[128]);
            assert_eq!(changes, 1, "radius {radius} from {along}");
        }
    }
}
