//! Where things are: all triangles in one tree, and the balls beside it.

use bvh::packed::PackedBvh;
use common::tally::Tally;
use glam::{Vec2, Vec3};
use partitions::accelerator::Accelerator;
use ray_casting::ray::Ray;
use ray_casting::rounding::Placed;
use ray_casting::shape::{Hit, SHAPE_TESTS, Shape};
use ray_casting::sphere::Sphere;
use shadows::occluder::Occluder;
use triangles::brute::Found;
use triangles::surface::{geometric_normal, place};

use crate::part::{Form, Part};

// ANCHOR: space
/// The shapes of a scene. It knows whose they are, and nothing of what they are made of.
///
/// Its pieces are numbered: first the triangles, then the balls.
#[derive(Clone, Debug)]
pub struct Space {
    tree: PackedBvh,
    triangles: Vec<Triangle>,
    balls: Vec<Ball>,
}

/// A triangle of the scene.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    corners: [Vec3; 3],
    normal: Vec3,
    owner: u32,
}

/// A ball of the scene.
#[derive(Clone, Copy, Debug)]
struct Ball {
    sphere: Sphere,
    owner: u32,
}

/// A piece of the scene, as a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A triangle, by its corners.
    Triangle([Vec3; 3]),
    /// A ball.
    Ball(Sphere),
}

/// Where a ray meets the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Met {
    /// The point and the normal.
    pub hit: Hit,
    /// The number of the piece it is on.
    pub piece: u32,
    /// The number of the thing that the piece belongs to.
    pub owner: u32,
}
// ANCHOR_END: space

impl Space {
    /// The shapes of these things, in their order.
    pub fn new<M>(parts: &[Part<M>]) -> Self {
        let (mut triangles, mut balls) = (Vec::new(), Vec::new());
        for (owner, part) in (0..).zip(parts) {
            match &part.form {
                Form::Triangles(all) => triangles.extend(all.iter().map(|&corners| {
                    // One without an area is never met.
                    let normal = geometric_normal(&corners).unwrap_or(Vec3::Z);
                    Triangle { corners, normal, owner }
                })),
                Form::Ball(sphere) => balls.push(Ball { sphere: *sphere, owner }),
            }
        }
        let corners = triangles.iter().map(|triangle| triangle.corners).collect();
        Self { tree: PackedBvh::build(corners), triangles, balls }
    }

    // ANCHOR: nearest
    /// What the ray meets first.
    pub fn nearest<T: Tally>(&self, ray: &Ray, tally: &mut T) -> Option<Met> {
        let found = self.tree.nearest(ray, f32::INFINITY, tally);
        let limit = found.map_or(f32::INFINITY, |found| found.hit.t);
        let ball = self.nearest_ball(ray, limit, tally);
        ball.or_else(|| found.map(|found| self.on_triangle(&found)))
    }
    // ANCHOR_END: nearest

    /// The nearest ball before `limit`.
    fn nearest_ball<T: Tally>(&self, ray: &Ray, limit: f32, tally: &mut T) -> Option<Met> {
        let mut nearest = None;
        let mut limit = limit;
        tally.count(SHAPE_TESTS, self.balls.len() as u64);
        for (index, ball) in self.balls.iter().enumerate() {
            if let Some(hit) = ball.sphere.hit(ray, limit) {
                limit = hit.t;
                let piece = (self.triangles.len() + index) as u32;
                nearest = Some(Met { hit, piece, owner: ball.owner });
            }
        }
        nearest
    }

    #[inline]
    fn on_triangle(&self, found: &Found) -> Met {
        let Triangle { corners, normal, owner } = self.triangles[found.index];
        let weights = found.hit.barycentric;
        let Placed { point, error } = place(corners, weights);
        let uv = Vec2::new(weights.y, weights.z);
        let hit = Hit { t: found.hit.t, point, error, geometric: normal, normal, uv };
        Met { hit, piece: found.index as u32, owner }
    }

    /// How many pieces there are.
    pub fn len(&self) -> usize {
        self.triangles.len() + self.balls.len()
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Piece number `piece`, and the number of the thing it belongs to.
    pub fn piece(&self, piece: usize) -> Option<(Piece, u32)> {
        if let Some(triangle) = self.triangles.get(piece) {
            return Some((Piece::Triangle(triangle.corners), triangle.owner));
        }
        let ball = self.balls.get(piece.checked_sub(self.triangles.len())?)?;
        Some((Piece::Ball(ball.sphere), ball.owner))
    }
}

impl Occluder for Space {
    fn blocks<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> bool {
        if self.tree.is_hit(ray, t_max, tally) {
            return true;
        }
        tally.count(SHAPE_TESTS, self.balls.len() as u64);
        self.balls.iter().any(|ball| ball.sphere.is_hit(ray, t_max))
    }
}
