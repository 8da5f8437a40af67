//! LS-06 and LS-07: lamps seen from their own plane, and from themselves.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{Vec2, Vec3};
use path_tracing::space::Piece;
use ray_casting::shape::Hit;
use triangles::surface::between;

use super::{CHAPTER, WAYS, decades, direction, is_broken, lamp};
use crate::naive;

/// A level lamp, a point that looks at it, and two numbers for the lamp's point.
struct View {
    corners: [Vec3; 3],
    from: Vec3,
    u: Vec2,
}

/// LS-06: the lamp has no width from there.
pub(super) const IN_PLANE: Case = Case {
    id: "LS-06",
    chapter: CHAPTER,
    input: "a lamp seen from a point of its own plane",
    most: UNLIMITED,
    naive_fails: |trial| in_plane(trial).naive_fails(),
    robust_fails: |trial| in_plane(trial).robust_fails(),
};

fn in_plane(trial: u64) -> View {
    let mut stream = Stream::of_trial(1336, trial);
    let height = stream.between(-2.0, 2.0);
    let mut point = || Vec3::new(stream.between(-1.0, 1.0), stream.between(-1.0, 1.0), height);
    let corners = [point(), point(), point()];
    View { corners, from: 3.0 * point().with_z(0.0) + height * Vec3::Z, u: stream.uniform2() }
}

/// LS-07: the lamp's point is where one stands, or 10⁻³⁰ from it.
pub(super) const COINCIDENT: Case = Case {
    id: "LS-07",
    chapter: CHAPTER,
    input: "a point of a lamp seen from itself, or from 10^-20 away",
    most: UNLIMITED,
    naive_fails: |trial| coincident(trial).naive_fails(),
    robust_fails: |trial| coincident(trial).robust_fails(),
};

fn coincident(trial: u64) -> View {
    let mut stream = Stream::of_trial(1337, trial);
    let mut corner = || Vec3::new(stream.between(-1.0, 1.0), stream.between(-1.0, 1.0), 0.0);
    // The first corner is the origin, where floats are dense, and the point that is chosen.
    let corners = [Vec3::ZERO, corner(), corner()];
    let distance = if trial.is_multiple_of(2) { 0.0 } else { decades(&mut stream, -44.0, -20.0) };
    View { corners, from: distance * direction(&mut stream), u: Vec2::new(0.0, stream.uniform()) }
}

impl View {
    /// A density that is no positive number, which a weight of 0 times infinity makes NaN.
    fn naive_fails(&self) -> bool {
        let weights = monte_carlo::warp::triangle::barycentric(self.u);
        let point = between(self.corners, weights);
        let pdf = naive::density(self.from, point, Vec3::Z, 1.0);
        !(pdf > 0.0 && pdf.is_finite())
    }

    fn robust_fails(&self) -> bool {
        let Some(lamp) = lamp(Piece::Triangle(self.corners)) else { return false };
        WAYS.into_iter().any(|way| {
            let Some(point) = lamp.point(self.from, way, self.u) else { return false };
            let Hit { point: place, .. } = point.hit;
            is_broken(&point) || place == self.from
        })
    }
}
