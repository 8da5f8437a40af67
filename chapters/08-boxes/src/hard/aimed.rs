//! BX-03: whatever hits a triangle hits its box.
//!
//! The rays are aimed at corners, edges and insides of triangles. Where chapter 2's test says "hit",
//! the box of that one triangle must be met, at a distance not above the hit's.

use std::sync::LazyLock;

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::bumpy;
use triangles::bunny::bunny;
use triangles::convert::Normals;
use triangles::intersect::TriangleTest;
use triangles::mesh::Mesh;
use triangles::watertight::ShearedRay;

use super::draw;
use crate::aabb::Aabb;
use crate::bounded::Bounded;
use crate::naive::PlainRay;
use crate::slab::BoxRay;

/// A ray, the triangle it is aimed at, and the box of the scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aimed {
    pub(crate) ray: Ray,
    corners: [Vec3; 3],
    pub(crate) scene: Aabb,
}

impl Aimed {
    /// The box of the triangle alone.
    pub(crate) fn bounds(&self) -> Aabb {
        self.corners.bounds()
    }

    /// Where the ray hits the triangle.
    pub(crate) fn hit(&self) -> Option<f32> {
        ShearedRay::prepare(&self.ray)?.hit(&self.corners, f32::INFINITY).map(|hit| hit.t)
    }

    /// Whether the triangle is hit and a form says its box isn't met, however far one looks.
    pub(crate) fn is_lost_by(&self, form: impl Fn(&PlainRay, &Aabb, f32) -> bool) -> bool {
        let meets = || form(&PlainRay::from(&self.ray), &self.bounds(), f32::INFINITY);
        self.hit().is_some() && !meets()
    }

    /// Whether the triangle is hit at some t, and the box is not entered by then.
    pub(crate) fn is_lost(&self) -> bool {
        let Some(t) = self.hit() else { return false };
        let enter = BoxRay::new(&self.ray, &self.scene).enter(&self.bounds(), t);
        !enter.is_some_and(|enter| enter <= t)
    }
}

/// A mesh's corners, triangle by triangle, and its box.
struct Target {
    corners: Vec<[Vec3; 3]>,
    scene: Aabb,
}

impl Target {
    fn new(mesh: &Mesh, offset: Vec3) -> Self {
        let corners: Vec<_> = mesh.all_corners();
        let corners: Vec<_> =
            corners.into_iter().map(|it| it.map(|corner| corner + offset)).collect();
        let scene = corners.iter().map(Bounded::bounds).fold(Aabb::EMPTY, Aabb::union);
        Self { corners, scene }
    }

    fn triangle(&self, stream: &mut Stream) -> [Vec3; 3] {
        self.corners[draw::below(stream, self.corners.len())]
    }
}

/// Two bumpy spheres and the bunny.
static NEAR: LazyLock<Vec<Target>> = LazyLock::new(|| {
    let spheres = [96, 960].map(|size| Target::new(&bumpy::sphere(size), Vec3::ZERO));
    let bunny = bunny(Normals::Flat).map(|mesh| Target::new(&mesh, Vec3::ZERO));
    spheres.into_iter().chain(bunny).collect()
});

/// A bumpy sphere at distances of about 10^3, 10^4 and 10^5.
static FAR: LazyLock<[Target; 3]> = LazyLock::new(|| {
    let away = Vec3::new(148_376.0, 1_234.0, -223_423.0);
    [0.004, 0.04, 0.4].map(|share| Target::new(&bumpy::sphere(960), share * away))
});

/// A point of a triangle: a corner, a point of an edge, or one inside.
fn place(stream: &mut Stream, [a, b, c]: &[Vec3; 3]) -> Vec3 {
    let edge = *a + stream.uniform() * (*b - *a);
    match draw::below(stream, 3) {
        0 => *a,
        1 => edge,
        _ => edge + stream.uniform() * (*c - edge),
    }
}

/// From anywhere in and around a mesh.
pub(crate) fn anywhere(trial: u64) -> Aimed {
    let mut stream = Stream::of_trial(831, trial);
    let target = &NEAR[(trial % NEAR.len() as u64) as usize];
    let corners = target.triangle(&mut stream);
    let at = place(&mut stream, &corners);
    let around = draw::point(&mut stream, 0.5 * target.scene.size().max_element());
    let origin = target.scene.center() + around;
    Aimed { ray: Ray { origin, direction: at - origin }, corners, scene: target.scene }
}

/// Far from the origin of coordinates, where there are few floats to aim at.
pub(crate) fn far_away(trial: u64) -> Aimed {
    let mut stream = Stream::of_trial(833, trial);
    let target = &FAR[(trial % 3) as usize];
    let corners = target.triangle(&mut stream);
    let at = place(&mut stream, &corners);
    let away = draw::decade(&mut stream, -1.0, 2.0);
    let origin = at + draw::point(&mut stream, away);
    Aimed { ray: Ray { origin, direction: at - origin }, corners, scene: target.scene }
}

/// Along a long edge that runs along an axis, from close by: a ray that starts near the foot of a
/// wall. It is aimed at the edge, but for as much as chapter 2's test can't tell.
pub(crate) fn room(trial: u64) -> Aimed {
    let mut stream = Stream::of_trial(832, trial);
    let axis = draw::below(&mut stream, 3);
    let length = draw::decade(&mut stream, 0.0, 3.0);
    let mut edge = Vec3::ZERO;
    edge[axis] = length * draw::sign(&mut stream);
    let base = draw::point(&mut stream, 1.0);
    let corners = [base, base + edge, base + draw::point(&mut stream, length)];
    let at =
        base + stream.uniform() * edge + draw::point(&mut stream, 0.25 * f32::EPSILON * length);
    let near_by = draw::decade(&mut stream, -4.0, 1.0);
    let mut away = draw::point(&mut stream, near_by);
    away[axis] = 4.0 * near_by * draw::sign(&mut stream);
    let origin = at + away;
    Aimed { ray: Ray { origin, direction: at - origin }, corners, scene: corners.bounds() }
}

/// Along an axis through the corners and edges of triangles with whole coordinates.
pub(crate) fn lattice(trial: u64) -> Aimed {
    let mut stream = Stream::of_trial(834, trial);
    let mut whole = || Vec3::from([(); 3].map(|()| draw::below(&mut stream, 9) as f32 - 4.0));
    let corners = [whole(), whole(), whole()];
    let at = corners[draw::below(&mut stream, 3)];
    let halfway = 0.5 * (at + corners[draw::below(&mut stream, 3)]);
    let mut direction = Vec3::from([(); 3].map(|()| 0.0_f32.copysign(draw::sign(&mut stream))));
    direction[draw::below(&mut stream, 3)] = draw::sign(&mut stream);
    let back = 1.0 + draw::below(&mut stream, 9) as f32;
    Aimed {
        ray: Ray { origin: halfway - back * direction, direction },
        corners,
        scene: corners.bounds(),
    }
}

/// At slivers, 10^-6 to 1 wide, from any side.
pub(crate) fn sliver(trial: u64) -> Aimed {
    let mut stream = Stream::of_trial(835, trial);
    let [a, side] = [draw::point(&mut stream, 1.0), draw::point(&mut stream, 1.0)];
    let width = draw::decade(&mut stream, -6.0, 0.0);
    let corners = [a, a + side, a + stream.uniform() * side + draw::point(&mut stream, width)];
    let at = place(&mut stream, &corners);
    let origin = draw::point(&mut stream, 3.0);
    Aimed { ray: Ray { origin, direction: at - origin }, corners, scene: corners.bounds() }
}
