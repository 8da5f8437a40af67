//! The rays: what a camera sends, where light goes on from what they hit, and towards a lamp.

use common::chapter::Failure;
use common::math;
use common::sampler::Stream;
use common::tally::Off;
use glam::{Vec2, Vec3};
use partitions::accelerator::Accelerator;
use ray_casting::camera::Camera;
use ray_casting::ray::Ray;
use triangles::scene::MeshScene;
use triangles::surface::{between, geometric_normal};

use crate::rivals::{Ours, Rival};

/// A ray, and how far it goes.
#[derive(Clone, Copy, Debug)]
pub struct Limited {
    /// The ray.
    pub ray: Ray,
    /// Hits count below this.
    pub t_max: f32,
}

/// A mesh with the rays to ask it.
pub struct Workload {
    /// The mesh's name, as on the command line.
    pub name: String,
    /// Its triangles.
    pub corners: Vec<[Vec3; 3]>,
    /// One ray a pixel, from the camera.
    pub primary: Vec<Limited>,
    /// From each of their hits in a direction with a density like the cosine to the normal.
    pub bounce: Vec<Limited>,
    /// From each of their hits that faces it to a lamp above.
    pub shadow: Vec<Limited>,
}

impl Workload {
    /// The mesh called `name` ("bunny", "sphere:N" or an OBJ file), seen by `width` times three
    /// quarters of `width` pixels.
    ///
    /// # Errors
    /// As for [`MeshScene::named`]; and a view that is none.
    pub fn named(name: &str, width: u32) -> Result<Self, Failure> {
        let scene = MeshScene::named(name)?;
        let height = width * 3 / 4;
        let camera = Camera::new(&scene.view, width, height)
            .map_err(|error| Failure::Work(error.to_string()))?;
        let corners = scene.mesh.all_corners();
        let pixels =
            (0..height).flat_map(|y| (0..width).map(move |x| Vec2::new(x as f32, y as f32)));
        let primary: Vec<Limited> = pixels
            .map(|pixel| Limited { ray: camera.ray(pixel + 0.5), t_max: f32::INFINITY })
            .collect();
        let size = scene.mesh.extent().map_or(1.0, |extent| (extent.high - extent.low).length());
        let middle = scene.mesh.extent().map_or(Vec3::ZERO, |it| 0.5 * (it.high + it.low));
        let lamp = middle + size * Vec3::new(0.5, 1.0, 0.7);
        let tree = Ours::build(&corners);
        let (mut bounce, mut shadow) = (Vec::new(), Vec::new());
        for (pixel, Limited { ray, t_max }) in (0..).zip(&primary) {
            let Some(found) = tree.tree.nearest(ray, *t_max, &mut Off) else { continue };
            let triangle = corners[found.index];
            let Some(normal) = geometric_normal(&triangle) else { continue };
            let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
            let start = between(triangle, found.hit.barycentric) + 1e-4 * size * normal;
            let mut stream = Stream::of_trial(10, pixel);
            let direction = cosine(normal, stream.uniform2());
            bounce.extend(limited(start, direction, f32::INFINITY));
            let spread = stream.uniform2() - 0.5;
            let toward = lamp + 0.15 * size * Vec3::new(spread.x, 0.0, spread.y) - start;
            if toward.dot(normal) > 0.0 {
                shadow.extend(limited(start, toward, 0.999 * toward.length()));
            }
        }
        Ok(Self { name: name.into(), corners, primary, bounce, shadow })
    }

    /// The three sets with their names; the last is asked for any hit.
    pub fn sets(&self) -> [(&'static str, &[Limited]); 3] {
        [("primary", &self.primary), ("bounce", &self.bounce), ("shadow", &self.shadow)]
    }
}

fn limited(origin: Vec3, direction: Vec3, t_max: f32) -> Option<Limited> {
    Ray::new(origin, direction).map(|ray| Limited { ray, t_max })
}

/// A direction on the normal's side with a density proportional to its cosine: a point of the disk,
/// lifted to the hemisphere.
fn cosine(normal: Vec3, random: Vec2) -> Vec3 {
    let (radius, angle) = (random.x.sqrt(), std::f32::consts::TAU * random.y);
    let side = if normal.x.abs() > 0.5 { Vec3::Y } else { Vec3::X };
    let tangent = normal.cross(side).normalize();
    let up = (1.0 - random.x).max(0.0).sqrt();
    radius * math::cos(angle) * tangent
        + radius * math::sin(angle) * normal.cross(tangent)
        + up * normal
}
