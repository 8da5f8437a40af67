//! Whether the two orders agree at a sample, and if not, whether they may differ there.

use common::tally::Event;
use glam::DVec2;
use triangles::mesh::Mesh;

use crate::clip::Volume;
use crate::fixed::STEPS;
use crate::fragment::Fragment;
use crate::interpolate::Interpolation;
use crate::project::{FilmPoint, Projection};
use crate::setup::project;

/// Samples at which the two orders name different triangles.
pub const IDS_DIFFER: Event = Event::new(3, 6, "ids_differ");
/// Those of them that nothing excuses. There should be none.
pub const UNJUSTIFIED: Event = Event::new(3, 7, "unjustified");

/// How far apart two depths may be, relative to them: 8 units u = 2⁻²⁴ of f32 rounding.
pub const DEPTH_TOLERANCE: f64 = 8.0 / 16_777_216.0;

// ANCHOR: verdict
/// What comparing the two orders at one sample comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// They name the same triangle, or none.
    Same,
    /// They differ, within 1/256 pixel of an edge of one of the two triangles.
    AtAnEdge,
    /// They differ, where both triangles are equally deep to within 8 u.
    EquallyDeep,
    /// They differ because the ray's hit is nearer than the near plane.
    BeforeTheNearPlane,
    /// They differ, and nothing excuses it.
    Unjustified,
}
// ANCHOR_END: verdict

/// A mesh on the film, to judge samples by. Nothing in it is snapped.
#[derive(Clone, Debug)]
pub struct Judge<'a> {
    mesh: &'a Mesh,
    vertices: Vec<FilmPoint>,
    volume: Option<Volume>,
}

impl<'a> Judge<'a> {
    /// A judge of pictures of `mesh` by the camera of `projection`.
    pub fn new(mesh: &'a Mesh, projection: &Projection) -> Self {
        let (vertices, deepest) = project(projection, &mesh.positions);
        Self { mesh, vertices, volume: Volume::for_depth(deepest) }
    }

    // ANCHOR: judge
    /// Compares what the two orders see at `sample` (in pixels).
    pub fn judge(
        &self,
        sample: DVec2,
        object: Option<Fragment>,
        image: Option<Fragment>,
    ) -> Verdict {
        let [object_id, image_id] = [object, image].map(|it| it.map(|it| it.triangle));
        if object_id == image_id {
            return Verdict::Same;
        }
        let close = |id: u32| self.edge_distance(id, sample) <= 1.0 / f64::from(STEPS);
        if object_id.is_some_and(close) || image_id.is_some_and(close) {
            return Verdict::AtAnEdge;
        }
        let near = self.volume.map_or(0.0, |volume| volume.near);
        if image.is_some_and(|image| f64::from(image.depth) <= near * (1.0 + DEPTH_TOLERANCE)) {
            return Verdict::BeforeTheNearPlane;
        }
        let depths = [object_id, image_id].map(|id| self.depth(id?, sample));
        match depths {
            [Some(one), Some(other)] if close_depths(one, other) => Verdict::EquallyDeep,
            _ => Verdict::Unjustified,
        }
    }
    // ANCHOR_END: judge

    /// The depth of a triangle's plane at a sample.
    pub fn depth(&self, triangle: u32, sample: DVec2) -> Option<f64> {
        Some(Interpolation::new(self.corners(triangle))?.surface(sample).depth)
    }

    // ANCHOR: distance
    /// How far a sample lies from the nearest edge of a triangle, in pixels.
    pub fn edge_distance(&self, triangle: u32, sample: DVec2) -> f64 {
        let Some(volume) = self.volume else { return f64::INFINITY };
        let polygon = volume.clip(self.corners(triangle));
        let corners = polygon.corners();
        let next = |index: usize| corners[(index + 1) % corners.len()];
        let edges = corners.iter().enumerate().map(|(index, &corner)| (corner, next(index)));
        edges
            .map(|(from, to)| to_segment(sample, from.divide(), to.divide()))
            .fold(f64::INFINITY, f64::min)
    }
    // ANCHOR_END: distance

    fn corners(&self, triangle: u32) -> [FilmPoint; 3] {
        self.mesh.triangles[triangle as usize].map(|vertex| self.vertices[vertex as usize])
    }
}

/// Whether two depths agree to within 8 u.
pub fn close_depths(one: f64, other: f64) -> bool {
    (one - other).abs() <= DEPTH_TOLERANCE * one.abs().max(other.abs())
}

/// The distance of a point from the line between two others.
fn to_segment(point: DVec2, from: DVec2, to: DVec2) -> f64 {
    let (along, offset) = (to - from, point - from);
    let length = along.length_squared();
    if length == 0.0 {
        return offset.length();
    }
    let share = (offset.dot(along) / length).clamp(0.0, 1.0);
    // Across the line the cross product is exact where the difference of two far points is not.
    if share > 0.0 && share < 1.0 {
        offset.perp_dot(along).abs() / length.sqrt()
    } else {
        (offset - share * along).length()
    }
}

#[cfg(test)]
mod tests {
    use common::tally::Off;
    use glam::{DVec2, Vec3};
    use ray_casting::camera::{Camera, View};
    use triangles::bumpy;
    use triangles::mesh::Mesh;
    use triangles::surface;

    use super::{DEPTH_TOLERANCE, Judge, Verdict, close_depths};
    use crate::fragment::Fragment;
    use crate::image;
    use crate::project::Projection;
    use crate::rasterizer::Rasterizer;

    const WIDTH: u32 = 150;
    const HEIGHT: u32 = 97;

    /// A sphere from outside, and one around the eye.
    fn sights() -> [(Mesh, Camera); 2] {
        [(900, Vec3::new(0.6, 1.2, 3.2)), (400, Vec3::new(0.15, -0.1, 0.25))].map(|(count, eye)| {
            let target = Vec3::new(-0.1, 0.2, -0.3);
            let view = View { eye, target, up: Vec3::Y, vertical_fov: 48.0 };
            let camera = Camera::new(&view, WIDTH, HEIGHT).expect("a good view");
            (bumpy::sphere(count), camera)
        })
    }

    fn centres() -> impl Iterator<Item = DVec2> {
        (0..HEIGHT)
            .flat_map(|y| (0..WIDTH).map(move |x| (x, y)))
            .map(|(x, y)| DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5))
    }

    fn objects(mesh: &Mesh, camera: &Camera) -> Vec<Option<Fragment>> {
        Rasterizer::new::<true, Off>(mesh, camera, &mut Off).fragments(&mut Off)
    }

    #[test]
    fn both_orders_see_the_same_triangles_but_for_excused_samples() {
        for (mesh, camera) in sights() {
            let judge = Judge::new(&mesh, &Projection::new(&camera));
            let images = image::fragments(&mesh.all_corners(), &camera, &mut Off);
            let pairs = objects(&mesh, &camera).into_iter().zip(images);
            let verdicts: Vec<_> = pairs
                .zip(centres())
                .map(|((object, image), centre)| judge.judge(centre, object, image))
                .collect();
            let count = |verdict| verdicts.iter().filter(|&&it| it == verdict).count();
            assert_eq!(count(Verdict::Unjustified), 0);
            assert!(count(Verdict::AtAnEdge) < 20, "{} at edges", count(Verdict::AtAnEdge));
        }
    }

    #[test]
    fn the_judge_finds_a_camera_that_is_off_by_a_tenth_of_a_pixel() {
        let [(mesh, camera), _] = sights();
        let judge = Judge::new(&mesh, &Projection::new(&camera));
        let corners = mesh.all_corners();
        let pairs = objects(&mesh, &camera).into_iter().zip(centres());
        let unjustified = pairs.filter(|&(object, centre)| {
            let beside = centre.as_vec2() + glam::Vec2::new(0.1, 0.0);
            let image = image::fragment(&corners, &camera, beside, &mut Off);
            judge.judge(centre, object, image) == Verdict::Unjustified
        });
        assert!(unjustified.count() > 100);
    }

    #[test]
    fn depths_agree_to_8_units_with_the_exact_plane() {
        for (mesh, camera) in sights() {
            let judge = Judge::new(&mesh, &Projection::new(&camera));
            for (object, centre) in objects(&mesh, &camera).into_iter().zip(centres()) {
                let Some(Fragment { triangle, depth, .. }) = object else { continue };
                if judge.edge_distance(triangle, centre) > 1.0 / 256.0 {
                    let exact = judge.depth(triangle, centre).expect("it was drawn");
                    assert!(close_depths(f64::from(depth), exact), "{centre}: {depth} {exact}");
                }
            }
        }
    }

    #[test]
    fn depths_agree_with_the_rays_to_8_units_over_the_cosine() {
        // The ray test rounds the corners sideways by a few u, and a surface that is seen at a
        // slant turns that into depth: by the tangent of the angle to its normal.
        let mut worst = 0.0_f64;
        for (mesh, camera) in sights() {
            let images = image::fragments(&mesh.all_corners(), &camera, &mut Off);
            let pairs = objects(&mesh, &camera).into_iter().zip(images).zip(centres());
            for ((object, image), centre) in pairs {
                let (Some(object), Some(image)) = (object, image) else { continue };
                if object.triangle != image.triangle {
                    continue;
                }
                let normal = surface::area_vector(&mesh.corners(object.triangle as usize));
                let ray = camera.ray(centre.as_vec2()).direction.as_dvec3();
                let cosine = normal.normalize().dot(ray).abs();
                let [one, other] = [object, image].map(|it| f64::from(it.depth));
                worst = worst.max((one - other).abs() / one * cosine / DEPTH_TOLERANCE);
            }
        }
        assert!(worst > 0.0 && worst < 1.0, "{worst}");
    }

    #[test]
    fn a_scene_scaled_by_a_power_of_two_is_the_same_picture() {
        let seen = |scale: f32| {
            let mut mesh = bumpy::sphere(400);
            mesh.positions.iter_mut().for_each(|point| *point *= scale);
            let eye = Vec3::new(0.15, -0.1, 0.25) * scale;
            let target = Vec3::new(-0.5, 0.2, -0.3) * scale;
            let view = View { eye, target, up: Vec3::Y, vertical_fov: 48.0 };
            let camera = Camera::new(&view, WIDTH, HEIGHT).expect("a good view");
            let fragments = objects(&mesh, &camera).into_iter().flatten();
            fragments.map(|it| (it.triangle, it.barycentric, it.depth / scale)).collect::<Vec<_>>()
        };
        let original = seen(1.0);
        assert!(!original.is_empty());
        assert!([1.0 / 1024.0, 65_536.0].iter().all(|&scale| seen(scale) == original));
    }
}
