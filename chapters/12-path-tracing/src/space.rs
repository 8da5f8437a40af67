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

#[cfg(test)]
mod tests {
    use common::tally::{Counts, Off};
    use glam::Vec3;
    use ray_casting::ray::Ray;
    use ray_casting::shape::SHAPE_TESTS;
    use shadows::occluder::Occluder;

    use super::{Piece, Space};
    use crate::part::{Form, Part};

    /// A wall at z = 5, a ball before it around z = 2, and one behind it.
    fn space() -> Space {
        let corners = [[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]];
        let wall = Form::quad(corners.map(|[x, y]| Vec3::new(x, y, 5.0)));
        let balls = [2.0, 9.0].map(|z| Part::dark(Form::ball(Vec3::new(0.0, 0.0, z), 0.5), ()));
        let [before, behind] = balls;
        Space::new(&[before, Part::dark(wall, ()), behind])
    }

    fn along_z(x: f32) -> Ray {
        Ray { origin: Vec3::new(x, 0.25, 0.0), direction: Vec3::Z }
    }

    #[test]
    fn the_nearest_of_triangles_and_balls() {
        let space = space();
        let met = space.nearest(&along_z(0.25), &mut Off).expect("the ball");
        assert_eq!((met.owner, met.piece), (0, 2), "after the two triangles");
        assert!(met.hit.normal.z < 0.0 && met.hit.t < 2.0);
        let met = space.nearest(&along_z(3.0), &mut Off).expect("the wall");
        assert_eq!((met.owner, met.hit.t), (1, 5.0));
        assert_eq!((met.hit.normal, met.hit.point.z), (Vec3::Z, 5.0));
        assert!(space.nearest(&along_z(20.0), &mut Off).is_none());
    }

    #[test]
    fn something_is_in_the_way_or_not() {
        let space = space();
        let mut counts = Counts::default();
        assert!(space.blocks(&along_z(0.25), 3.0, &mut counts));
        assert!(!space.blocks(&along_z(0.25), 1.0, &mut counts));
        assert!(space.blocks(&along_z(3.0), 5.5, &mut counts));
        assert!(!space.blocks(&along_z(3.0), 4.5, &mut counts));
        assert_eq!(counts.of(SHAPE_TESTS), 6, "the wall answers before the balls are asked");
    }

    #[test]
    fn pieces_have_their_owners() {
        let space = space();
        assert_eq!((space.len(), space.is_empty()), (4, false));
        let owners: Vec<u32> = (0..4).filter_map(|it| space.piece(it)).map(|it| it.1).collect();
        assert_eq!(owners, [1, 1, 0, 2]);
        assert!(matches!(space.piece(0), Some((Piece::Triangle(_), 1))));
        assert!(matches!(space.piece(3), Some((Piece::Ball(_), 2))));
        assert_eq!(space.piece(4), None);
    }

    #[test]
    fn nothing_is_met_in_nothing_and_on_what_has_no_area() {
        let empty = Space::new::<()>(&[]);
        assert!(empty.is_empty() && empty.nearest(&along_z(0.0), &mut Off).is_none());
        let line = Form::Triangles(vec![[Vec3::ZERO, 5.0 * Vec3::Z, 9.0 * Vec3::Z]]);
        let space = Space::new(&[Part::dark(line, ())]);
        let ray = Ray { origin: Vec3::new(-1.0, 0.0, 3.0), direction: Vec3::X };
        assert!(space.nearest(&ray, &mut Off).is_none());
    }
}
