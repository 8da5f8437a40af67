//! Rooms of all sizes: exercise 5.4.

use glam::Vec3;
use ray_casting::quad::Quad;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Shape};
use ray_casting::sphere::Sphere;

/// A sloping floor, and a lamp over it; a ball before the lamp, or behind it, or none.
#[derive(Debug)]
pub(crate) struct Room {
    scale: f32,
    place: [f32; 2],
    ball: Option<[f32; 2]>,
    /// Known from how it is made.
    pub(crate) is_lit: bool,
}

/// The lamp, in a room of size 1.
const LAMP: Vec3 = Vec3::new(0.4, 5.0, -1.0);

pub(crate) fn rooms() -> Vec<Room> {
    let balls = [
        (None, true),
        // In the middle of the way, right before the lamp, behind it: where along, and how large.
        (Some([0.5, 0.6]), false),
        (Some([0.99, 0.03]), false),
        (Some([1.4, 0.5]), true),
    ];
    let sizes = [1.0, 1.0 / 1024.0, 1e-5, 300.0, 1e4];
    let places = [[0.3, 0.2], [-1.7, 0.9], [1.1, -2.3], [2.9, 1.3], [-0.6, -1.9]];
    let room = |scale, (ball, is_lit)| places.map(|place| Room { scale, place, ball, is_lit });
    let of_size = |scale| balls.into_iter().flat_map(move |ball| room(scale, ball));
    sizes.into_iter().flat_map(of_size).collect()
}

impl Room {
    fn floor(&self) -> Quad {
        let edges = [Vec3::new(8.0, 0.7, 0.3), Vec3::new(0.2, 1.1, -8.0)];
        let corner = self.scale * Vec3::new(-4.0, -1.0, 4.0);
        Quad::new(corner, edges.map(|edge| self.scale * edge)).expect("the edges span an area")
    }

    /// Where the floor is seen from above.
    pub(crate) fn hit(&self) -> Hit {
        let [x, z] = self.place;
        let origin = self.scale * Vec3::new(x, 3.0, z);
        let ray = Ray { origin, direction: Vec3::new(0.1, -1.0, 0.05) };
        self.floor().hit(&ray, f32::INFINITY).expect("the floor is below")
    }

    pub(crate) fn lamp(&self) -> Vec3 {
        self.scale * LAMP
    }

    pub(crate) fn shapes(&self) -> Vec<Box<dyn Shape>> {
        let mut shapes: Vec<Box<dyn Shape>> = vec![Box::new(self.floor())];
        if let Some([along, radius]) = self.ball {
            let center = self.hit().point.lerp(self.lamp(), along);
            shapes.push(Box::new(Sphere { center, radius: self.scale * radius }));
        }
        shapes
    }
}
