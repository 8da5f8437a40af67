//! RC-07: planes seen at a grazing angle.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::{CHAPTER, U, draw};
use crate::naive;
use crate::plane::Plane;
use crate::ray::Ray;

/// RC-07: "parallel" decided by a number without a unit.
pub(super) const GRAZING: Case = Case {
    id: "RC-07",
    chapter: CHAPTER,
    input: "a plane at 10^-5 to 1 rad, directions 10^-9 to 1 long",
    most: UNLIMITED,
    naive_fails: |trial| {
        let grazing = grazing(trial);
        let plane = grazing.plane;
        grazing.is_wrong(naive::plane_distance(grazing.point, plane.normal(), &grazing.ray))
    },
    robust_fails: |trial| {
        let grazing = grazing(trial);
        grazing.is_wrong(grazing.plane.distance(&grazing.ray, f32::INFINITY))
    },
};

struct Grazing {
    point: Vec3,
    plane: Plane,
    ray: Ray,
}

fn grazing(trial: u64) -> Grazing {
    let mut stream = Stream::of_trial(207, trial);
    let normal = draw::direction(&mut stream);
    let point = draw::in_cube(&mut stream, 3.0);
    let away = draw::across(&mut stream, normal) * f64::from(stream.between(0.0, 10.0));
    let origin = (point.as_dvec3() + normal + away).as_vec3();
    let down = normal * f64::from(draw::decade(&mut stream, -5.0, 0.0));
    let direction = (draw::across(&mut stream, normal) - down).normalize().as_vec3();
    let ray = Ray { origin, direction: direction * draw::decade(&mut stream, -9.0, 0.0) };
    let plane = Plane::new(point, normal.as_vec3());
    let plane = plane.expect("a direction of length 1 and a finite point make a plane");
    Grazing { point, plane, ray }
}

impl Grazing {
    /// Each dot product is wrong by a few roundings of its largest term, which is all the result
    /// may be wrong by: the smaller the cosine, the more.
    fn is_wrong(&self, found: Option<f32>) -> bool {
        let normal = self.plane.normal().as_dvec3();
        let (origin, direction) = (self.ray.origin.as_dvec3(), self.ray.direction.as_dvec3());
        let from_origin = self.point.as_dvec3() - origin;
        let height = from_origin.dot(normal);
        let cosine = direction.dot(normal);
        let exact = height / cosine;
        let lengths = from_origin.length() / height.abs() + direction.length() / cosine.abs();
        let bound = 4.0 * U * lengths * exact;
        !found.is_some_and(|t| (f64::from(t) - exact).abs() <= bound)
    }
}
