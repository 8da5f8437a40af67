//! TR-01, TR-05 to TR-09: triangles that are very small, large, slim, flat or seen edge-on.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::shapes::{Corners, ask, distance, inner_weights, mix, point, towards, triangle};
use crate::area::has_area;
use crate::intersect::TriangleTest;
use crate::naive::{self, BareShear, MollerTrumbore, Plucker, Unguarded};
use crate::watertight::ShearedRay;

/// A ray and a triangle.
struct Scene {
    ray: Ray,
    corners: Corners,
}

/// A power of ten with a random exponent, in f64 and rounded once.
fn power_of_ten(low: f32, high: f32, stream: &mut Stream) -> f32 {
    common::math::pow(10.0, stream.between(low, high))
}

/// A ray from as far away as the triangle is large, at a point well inside it. None in the rare
/// case that it looks at the triangle almost edge-on.
fn plain_hit(scale: f32, stream: &mut Stream) -> Option<Scene> {
    let corners = triangle(stream);
    let target = mix(&corners, inner_weights(stream));
    let origin = point(stream);
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    let facing = (target - origin).dot(normal).abs();
    let clear =
        facing > 0.1 * (target - origin).length() * normal.length() && normal.length() > 0.1;
    let ray = towards(scale * origin, scale * target)?;
    clear.then_some(Scene { ray, corners: corners.map(|corner| scale * corner) })
}

/// TR-01: Möller and Trumbore's determinant shrinks with the square of the triangle's size, their
/// epsilon doesn't.
fn small_missed<Test: TriangleTest>(trial: u64) -> bool {
    let mut stream = Stream::of_trial(201, trial);
    let scale = power_of_ten(-6.0, -2.0, &mut stream);
    let scene = plain_hit(scale, &mut stream);
    scene.is_some_and(|it| ask::<Test>(&it.ray, &it.corners, f32::INFINITY).is_none())
}

pub(super) fn small_naive(trial: u64) -> bool {
    small_missed::<MollerTrumbore>(trial)
}

pub(super) fn small_robust(trial: u64) -> bool {
    small_missed::<ShearedRay>(trial)
}

/// TR-05: the catalogue's slim triangle, eleven units long, and others like it.
fn slim(trial: u64) -> Scene {
    let mut stream = Stream::of_trial(205, trial);
    let mut corners = [
        Vec3::new(-172.246_25, -43.9104, -211.445),
        Vec3::new(-163.952_62, -46.342_136, -218.568_37),
        Vec3::new(-165.137_77, -45.855_392, -217.598_74),
    ];
    let origin = Vec3::new(237.758_24, -182.956_94, -557.066);
    let direction = Vec3::new(-0.739_983_1, 0.255_56, 0.622_185);
    if trial > 0 {
        corners = corners.map(|corner| corner + 1e-4 * point(&mut stream));
    }
    Scene { ray: Ray { origin, direction }, corners }
}

/// Whether there is a hit, and the point it reports lies off the triangle by more than rounding
/// explains: u (|origin| + t) over the cosine between the ray and the normal, times 4.
fn hits_beside<Test: TriangleTest>(trial: u64) -> bool {
    let Scene { ray, corners } = slim(trial);
    let Some(hit) = ask::<Test>(&ray, &corners, f32::INFINITY) else { return false };
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let cosine = (b - a).cross(c - a).normalize().dot(direction).abs();
    let size = origin.length() + f64::from(hit.t);
    let allowed = 4.0 * f64::from(f32::EPSILON) / 2.0 * size / cosine;
    distance(origin + f64::from(hit.t) * direction, &corners) > allowed
}

pub(super) fn grazing_naive(trial: u64) -> bool {
    hits_beside::<Plucker>(trial)
}

pub(super) fn grazing_robust(trial: u64) -> bool {
    hits_beside::<ShearedRay>(trial)
}

/// TR-06: three points of a lattice on one line, so exactly in line, and a ray at one of them. Trial
/// 0 is pbrt-v4's `Triangle.BadCases`.
fn in_line(trial: u64) -> Option<Scene> {
    if trial == 0 {
        let corner = |y| Vec3::new(-1113.4546, y, -56.243_19);
        let origin = Vec3::new(-1081.4793, 99.999_954, 87.770_11);
        let direction = Vec3::new(-32.1073, -183.355_86, -144.607_63);
        let corners = [corner(-79.049_614), corner(-87.092_27), corner(-79.209_015)];
        return Some(Scene { ray: Ray { origin, direction }, corners });
    }
    let mut stream = Stream::of_trial(206, trial);
    let start = (1000.0 * point(&mut stream)).round();
    let step = (8.0 * point(&mut stream)).round();
    let corners = [0.0, 33.0, 71.0].map(|steps: f32| start + steps * step);
    let target = corners[0] + 71.0 * stream.uniform() * step;
    let ray = towards(1000.0 * point(&mut stream), target)?;
    (step != Vec3::ZERO).then_some(Scene { ray, corners })
}

fn hits_a_line<Test: TriangleTest>(trial: u64) -> bool {
    in_line(trial).is_some_and(|it| ask::<Test>(&it.ray, &it.corners, f32::INFINITY).is_some())
}

pub(super) fn in_line_naive(trial: u64) -> bool {
    hits_a_line::<BareShear>(trial)
}

pub(super) fn in_line_robust(trial: u64) -> bool {
    hits_a_line::<ShearedRay>(trial)
}

/// TR-07: a triangle in a plane across an axis, and a ray in the same plane through its middle. It
/// is seen as a line, and a line is a miss. Trial 0 is the one of Embree's issue 298.
fn in_plane(trial: u64) -> Option<Scene> {
    if trial == 0 {
        let ray = Ray { origin: Vec3::new(-1.0, 0.5, 0.0), direction: Vec3::X };
        return Some(Scene { ray, corners: [Vec3::ZERO, Vec3::X, Vec3::Y] });
    }
    let mut stream = Stream::of_trial(207, trial);
    let level = stream.between(-3.0, 3.0);
    let flat = |at: Vec3| match trial % 3 {
        0 => at.with_x(level),
        1 => at.with_y(level),
        _ => at.with_z(level),
    };
    let corners = triangle(&mut stream).map(flat);
    let target = flat(mix(&corners, inner_weights(&mut stream)));
    let ray = towards(flat(3.0 * point(&mut stream)), target)?;
    Some(Scene { ray, corners })
}

fn hits_in_plane<Test: TriangleTest>(trial: u64) -> bool {
    in_plane(trial).is_some_and(|it| ask::<Test>(&it.ray, &it.corners, f32::INFINITY).is_some())
}

pub(super) fn in_plane_naive(trial: u64) -> bool {
    hits_in_plane::<Unguarded>(trial)
}

pub(super) fn in_plane_robust(trial: u64) -> bool {
    hits_in_plane::<ShearedRay>(trial)
}

/// TR-08: a huge triangle one unit before the eye. The distance must be 1, whatever its size.
fn wrong_when_huge<Test: TriangleTest>(trial: u64) -> bool {
    let mut stream = Stream::of_trial(208, trial);
    let size = power_of_ten(17.0, 37.0, &mut stream);
    let shape = [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -0.7, 0.0), Vec3::new(0.1, 1.0, 0.0)];
    let corners = shape.map(|corner| size * corner + Vec3::Z);
    let ray = Ray { origin: 0.1 * point(&mut stream).with_z(0.0), direction: Vec3::Z };
    // A comparison that NaN fails.
    !ask::<Test>(&ray, &corners, f32::INFINITY).is_some_and(|hit| (hit.t - 1.0).abs() < 1e-6)
}

pub(super) fn huge_naive(trial: u64) -> bool {
    wrong_when_huge::<BareShear>(trial)
}

pub(super) fn huge_robust(trial: u64) -> bool {
    wrong_when_huge::<ShearedRay>(trial)
}

/// TR-09: a tiny triangle, hit well inside, by a test that first asks whether it has an area.
fn tiny_lost(trial: u64, has_area: fn(&Corners) -> bool) -> bool {
    let mut stream = Stream::of_trial(209, trial);
    let scale = power_of_ten(-30.0, -6.0, &mut stream);
    let hit = |it: &Scene| {
        has_area(&it.corners) && ask::<ShearedRay>(&it.ray, &it.corners, f32::INFINITY).is_some()
    };
    plain_hit(scale, &mut stream).is_some_and(|scene| !hit(&scene))
}

pub(super) fn tiny_naive(trial: u64) -> bool {
    tiny_lost(trial, naive::has_area)
}

pub(super) fn tiny_robust(trial: u64) -> bool {
    tiny_lost(trial, has_area)
}
