//! Hits that are lost to their own boxes, seen.

use common::film::{Color, Film};
use glam::{Vec2, Vec3};
use ray_casting::camera::{Camera, View};
use ray_casting::ray::Ray;
use triangles::brute::Found;
use triangles::bumpy;
use triangles::lanes::Packed;
use triangles::mesh::Mesh;
use triangles::surface;

use crate::aabb::Aabb;
use crate::bounded::Bounded;
use crate::naive::{PlainRay, tavian_2022};
use crate::slab::BoxRay;

const SIDE: u32 = 320;
const GAP: u32 = 8;
const LOST: Color = Color::new(1.0, 0.0, 0.1);

/// How near to a corner a ray must come to be aimed at it, as a barycentric weight.
const NEAR_CORNER: f32 = 0.72;

/// A bumpy sphere, each triangle behind a box of its own, twice: unpadded and ours. A ray that passes
/// near a corner is aimed anew, at the corner itself. Where the box of what it then hits isn't met,
/// the pixel is red.
pub fn picture() -> Option<Film> {
    let mesh = bumpy::sphere(1400);
    let (packed, scene) = (Packed::new(mesh.all_corners()), mesh.bounds());
    let eye = Vec3::new(0.6, 0.8, 2.9);
    let view = View { eye, target: Vec3::ZERO, up: Vec3::Y, vertical_fov: 45.0 };
    let camera = Camera::new(&view, SIDE, SIDE).ok()?;
    let stage = Stage { mesh, packed, camera };
    let unpadded =
        |ray: &Ray, bounds: &Aabb| tavian_2022(&PlainRay::from(ray), bounds, f32::INFINITY);
    let ours =
        |ray: &Ray, bounds: &Aabb| BoxRay::new(ray, &scene).enter(bounds, f32::INFINITY).is_some();
    Some(Film::from_fn(2 * SIDE + GAP, SIDE, |x, y| {
        if x < SIDE {
            stage.color(x, y, unpadded)
        } else if x < SIDE + GAP {
            Color::ONE
        } else {
            stage.color(x - SIDE - GAP, y, ours)
        }
    }))
}

struct Stage {
    mesh: Mesh,
    packed: Packed,
    camera: Camera,
}

impl Stage {
    fn color(&self, x: u32, y: u32, meets: impl Fn(&Ray, &Aabb) -> bool) -> Color {
        let ray = self.camera.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
        let Some(found) = self.packed.nearest(&ray, f32::INFINITY) else { return Color::ONE };
        let normal = surface::normal::<false>(&self.mesh, found.index, found.hit.barycentric);
        let aimed = self.at_corner(&ray, &found);
        let Some(hit) = self.packed.nearest(&aimed, f32::INFINITY) else { return Color::ONE };
        if meets(&aimed, &self.mesh.corners(hit.index).bounds()) {
            (normal + Vec3::ONE) / 2.0
        } else {
            LOST
        }
    }

    /// The ray at the nearest corner of the triangle it hits; the ray itself where none is near.
    fn at_corner(&self, ray: &Ray, found: &Found) -> Ray {
        let weights = found.hit.barycentric;
        if weights.max_element() < NEAR_CORNER {
            return *ray;
        }
        let corner = self.mesh.corners(found.index)[weights.max_position()];
        Ray { direction: corner - ray.origin, ..*ray }
    }
}
