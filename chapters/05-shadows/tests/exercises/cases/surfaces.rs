//! Points that may be off their surface, and surfaces with two normals: exercises 5.3 and 5.5.

use glam::{Vec2, Vec3};
use ray_casting::shape::Hit;

#[derive(Debug)]
pub(crate) struct Leaving {
    pub(crate) hit: Hit,
    pub(crate) direction: Vec3,
}

pub(crate) fn leavings() -> Vec<Leaving> {
    let leaving = |point: [f32; 3], normal: [f32; 3], error: [f32; 3], direction: [f32; 3]| {
        let geometric = Vec3::from(normal);
        let (point, error) = (point.into(), error.into());
        let hit = Hit { t: 1.0, point, error, geometric, normal: geometric, uv: Vec2::ZERO };
        Leaving { hit, direction: direction.into() }
    };
    let slanted = [0.6, 0.0, 0.8];
    vec![
        leaving([0.5, 0.25, 0.1], [0.0, 1.0, 0.0], [1e-4, 2e-4, 3e-4], [0.0, 1.0, 0.0]),
        leaving([0.5, 0.25, 0.1], [0.0, 1.0, 0.0], [1e-4, 2e-4, 3e-4], [0.0, -1.0, 0.0]),
        leaving([0.5, 0.25, 0.1], [0.0, 1.0, 0.0], [1e-4, 2e-4, 3e-4], [4.0, 3.0, 0.0]),
        leaving([0.5, 0.25, 0.1], slanted, [1e-4, 2e-4, 3e-4], [-0.1, 5.0, -0.2]),
        leaving([-700.0, 20.0, 900.0], slanted, [1e-2, 3e-3, 2e-2], [0.0, 0.0, 9.0]),
        // Half a step of these coordinates, and less.
        leaving([8e5, 9e5, -7e5], [0.0, 1.0, 0.0], [0.01, 0.02, 0.01], [0.3, 0.1, 0.0]),
        leaving([8e5, 9e5, -7e5], [0.0, 0.0, -1.0], [0.01, 0.02, 0.015], [0.3, 0.1, -2.0]),
        leaving([1e-6, 2e-6, 5e-6], [0.0, -1.0, 0.0], [2e-13, 1e-13, 1e-13], [1e-9, -1e-9, 0.0]),
    ]
}

impl Leaving {
    /// How far along the normal the surface may be.
    fn reach(&self) -> f64 {
        self.hit.geometric.as_dvec3().abs().dot(self.hit.error.as_dvec3())
    }

    /// How far `origin` is from the point, on the side of the direction, in the unit of the reach.
    pub(crate) fn clearance(&self, origin: Vec3) -> f64 {
        let normal = self.hit.geometric.as_dvec3();
        let side = normal.dot(self.direction.as_dvec3()).signum();
        side * (origin.as_dvec3() - self.hit.point.as_dvec3()).dot(normal) / self.reach()
    }

    /// Whether both are enough and not too much, or both the same.
    pub(crate) fn agree(&self, expected: f64, yours: f64) -> bool {
        let largest = self.hit.point.abs().max_element();
        let step = f64::from(largest.next_up()) - f64::from(largest);
        let most = 1.0 + 1.0 / 32.0 + 4.0 * step / self.reach();
        let good = |clearance| (0.999_999..most).contains(&clearance);
        let same = (expected - yours).abs() <= 1e-3 * expected.abs().max(1.0);
        good(expected) && good(yours) || !good(expected) && !good(yours) && same
    }
}

#[derive(Debug)]
pub(crate) struct Sides {
    pub(crate) geometric: Vec3,
    pub(crate) shading: Vec3,
    pub(crate) eye: Vec3,
    pub(crate) lamp: Vec3,
}

pub(crate) fn sides() -> Vec<Sides> {
    let unit = |vector: [f32; 3]| Vec3::from(vector).normalize();
    let sides = |geometric, shading, eye, lamp| Sides {
        geometric: unit(geometric),
        shading: unit(shading),
        eye: unit(eye),
        lamp: unit(lamp),
    };
    let (up, leaning) = ([0.0, 1.0, 0.0], [2.0, 1.0, 0.0]);
    vec![
        sides(up, up, [0.0, 2.0, 1.0], [1.0, 1.0, 0.0]),
        sides(up, up, [0.0, 2.0, 1.0], [1.0, -1.0, 0.0]),
        sides(up, up, [0.0, -2.0, 1.0], [1.0, -1.0, 0.0]),
        sides(up, leaning, [0.0, 2.0, 1.0], [1.0, 1.0, 0.0]),
        // Above the leaning normal's horizon, below the surface's.
        sides(up, leaning, [0.0, 2.0, 1.0], [3.0, -1.0, 0.0]),
        // And the other way round.
        sides(up, leaning, [0.0, 2.0, 1.0], [-3.0, 1.0, 0.0]),
        // The leaning normal points away from the eye, the surface's own to it.
        sides(up, leaning, [-3.0, 1.0, 0.0], [1.0, 2.0, 0.0]),
        sides([0.0, -1.0, 0.0], [-2.0, -1.0, 0.0], [-3.0, 1.0, 0.0], [1.0, 2.0, 0.0]),
        sides(up, leaning, [0.5, -1.0, 0.0], [-1.0, -2.0, 0.3]),
    ]
}

impl Sides {
    pub(crate) fn cosine(&self) -> f32 {
        let [geometric, shading, eye, lamp] =
            [self.geometric, self.shading, self.eye, self.lamp].map(|it| it.as_dvec3());
        let side = geometric.dot(eye).signum();
        if side * geometric.dot(lamp) <= 0.0 {
            return 0.0;
        }
        let leaning = shading.dot(geometric).signum() * side;
        (leaning * shading.dot(lamp)).max(0.0) as f32
    }
}
