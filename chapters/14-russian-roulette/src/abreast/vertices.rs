//! Where sixteen paths have come to.

use common::tally::Tally;
use glam::{Vec2, Vec3};
use monte_carlo::frame::Frame;
use path_tracing::lambert::Lambert;
use path_tracing::tracer::{LAMPS_MET, TRUNCATED_PATHS};
use ray_casting::rounding::Placed;
use ray_casting::shape::Hit;
use triangles::brute::TRIANGLE_TESTS;
use triangles::bundle::{Floats, RAYS, Vectors};
use triangles::nearest::{NONE, Nearest};
use triangles::surface::place;

use super::column::is_some;
use super::paths::{Paths, Tracer};

/// Where the paths are.
pub(super) struct Vertices {
    /// Whether the path met anything.
    pub(super) met: [bool; RAYS],
    pub(super) triangle: [u32; RAYS],
    point: Vectors,
    error: Vectors,
    normal: Vectors,
    pub(super) reflectance: Vectors,
    /// How high the eye is over the surface, for a way of length 1.
    pub(super) height: Floats,
    /// Whether it sends light on, and the path may go on.
    pub(super) spreads: [bool; RAYS],
}

impl Vertices {
    /// Where the paths have come to.
    #[inline(always)]
    pub(super) fn new<E>(paths: &Paths, tracer: &Tracer<E>, nearest: &Nearest) -> Self {
        let room = tracer.room;
        let places = &nearest.place;
        let [a, b, c] = &room.corners(places);
        let mut vertices = Self {
            met: [false; RAYS],
            triangle: nearest.place,
            point: Vectors::ZERO,
            error: Vectors::ZERO,
            normal: room.normal.of(places),
            reflectance: room.reflectance.of(places),
            height: [0.0; RAYS],
            spreads: [false; RAYS],
        };
        for path in 0..RAYS {
            let corners = [a.at(path), b.at(path), c.at(path)];
            let Placed { point, error } = place(corners, nearest.weights.at(path));
            vertices.point.set(path, point);
            vertices.error.set(path, error);
            vertices.height[path] = (-paths.direction.at(path)).dot(vertices.normal.at(path));
            let met = paths.used[path] & (nearest.place[path] != NONE);
            vertices.met[path] = met;
            let reflects = is_some(vertices.reflectance.at(path));
            vertices.spreads[path] = met & reflects & (paths.bounce[path] != tracer.depth);
        }
        vertices
    }

    /// The vertex of one path.
    #[inline(always)]
    pub(super) fn hit(&self, path: usize) -> Hit {
        on(Placed { point: self.point.at(path), error: self.error.at(path) }, self.normal.at(path))
    }

    /// Its axes.
    #[inline(always)]
    pub(super) fn frame(&self, path: usize) -> Frame {
        Frame::around(self.normal.at(path))
    }

    /// Its material.
    #[inline(always)]
    pub(super) fn material(&self, path: usize) -> Lambert {
        Lambert { reflectance: self.reflectance.at(path) }
    }

    /// Counts the rays, and what they met.
    #[inline(always)]
    pub(super) fn count<E, T: Tally>(&self, paths: &Paths, tracer: &Tracer<E>, tally: &mut T) {
        let Some(counts) = tally.counts() else { return };
        let (mut rays, mut lamps, mut cut) = (0, 0, 0);
        for path in 0..RAYS {
            let met = self.met[path];
            let glows = tracer.room.emission(self.triangle[path]).glows();
            let reflects = is_some(self.reflectance.at(path));
            rays += u64::from(paths.used[path]);
            lamps += u64::from(met & glows);
            cut += u64::from(met & reflects & (paths.bounce[path] == tracer.depth));
        }
        counts.count(TRIANGLE_TESTS, rays * tracer.room.few.len() as u64);
        counts.count(LAMPS_MET, lamps);
        counts.count(TRUNCATED_PATHS, cut);
    }
}

/// A point of a surface with this normal.
#[inline(always)]
pub(super) fn on(Placed { point, error }: Placed, normal: Vec3) -> Hit {
    Hit { t: 1.0, point, error, geometric: normal, normal, uv: Vec2::ZERO }
}
