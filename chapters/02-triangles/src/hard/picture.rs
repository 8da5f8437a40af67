//! The cracks, seen: rays aimed at edges, and those that slip through in a loud colour.

use common::film::{Color, Film};
use glam::{Vec2, Vec3};
use ray_casting::camera::{Camera, View};
use ray_casting::ray::Ray;

use super::shapes::towards;
use crate::brute::{Found, nearest};
use crate::bumpy;
use crate::intersect::TriangleTest;
use crate::lanes::Packed;
use crate::mesh::Mesh;
use crate::naive::MollerTrumbore;
use crate::surface;
use crate::watertight::ShearedRay;

const SIDE: u32 = 320;
const GAP: u32 = 8;
const CRACK: Color = Color::new(1.0, 0.0, 0.1);

/// How near to an edge a ray must come to be aimed at it, as a barycentric weight.
const NEAR_EDGE: f32 = 0.06;

/// A bumpy sphere from inside, twice: by Möller and Trumbore's test and by ours. A ray that passes
/// near an edge is aimed anew, at the edge itself. Where it then hits nothing it is red.
pub fn picture() -> Option<Film> {
    let mesh = bumpy::sphere(960);
    let packed = Packed::new(mesh.all_corners());
    let eye = Vec3::new(0.1, -0.05, 0.3);
    let view = View { eye, target: Vec3::new(0.4, 0.2, -1.0), up: Vec3::Y, vertical_fov: 70.0 };
    let camera = Camera::new(&view, SIDE, SIDE).ok()?;
    let scene = Scene { mesh, packed, camera };
    Some(Film::from_fn(2 * SIDE + GAP, SIDE, |x, y| {
        if x < SIDE {
            scene.color::<MollerTrumbore>(x, y)
        } else if x < SIDE + GAP {
            Color::ONE
        } else {
            scene.color::<ShearedRay>(x - SIDE - GAP, y)
        }
    }))
}

struct Scene {
    mesh: Mesh,
    packed: Packed,
    camera: Camera,
}

impl Scene {
    fn color<Test: TriangleTest>(&self, x: u32, y: u32) -> Color {
        let ray = self.camera.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
        let Some(found) = self.packed.nearest(&ray, f32::INFINITY) else { return CRACK };
        let normal = surface::normal::<false>(&self.mesh, found.index, found.hit.barycentric);
        let aimed = self.at_edge(&ray, &found).unwrap_or(ray);
        match nearest::<Test>(self.packed.corners(), &aimed, f32::INFINITY) {
            Some(_) => (normal + Vec3::ONE) / 2.0,
            None => CRACK,
        }
    }

    /// The ray at the nearest edge of the triangle it hits; None where that one isn't near.
    fn at_edge(&self, ray: &Ray, found: &Found) -> Option<Ray> {
        let weights = found.hit.barycentric;
        let least = weights.min_element();
        let on_edge = weights.map(|weight| if weight == least { 0.0 } else { weight });
        let on_edge = on_edge / on_edge.element_sum();
        let target = surface::between(self.mesh.corners(found.index), on_edge);
        if least < NEAR_EDGE { towards(ray.origin, target) } else { None }
    }
}
