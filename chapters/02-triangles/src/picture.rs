//! What each pixel shows of the nearest triangle.

use common::film::Color;
use common::render::{Rendering, Settings, render_counted};
use common::tally::{Event, Tally};
use glam::Vec3;
use ray_casting::camera::{CAMERA_RAYS, Camera};
use ray_casting::picture::{BACKGROUND, Show};
use ray_casting::ray::Ray;

use crate::brute::Found;
use crate::mesh::Mesh;
use crate::surface;

/// Normals interpolated between vertices.
pub const SMOOTH_NORMALS: Event = Event::new(2, 1, "smooth_normals");

/// A mesh, the camera it is seen with, and what is to be shown.
pub struct Picture<'a> {
    /// What there is to see.
    pub mesh: &'a Mesh,
    /// Where from.
    pub camera: Camera,
    /// What of it.
    pub show: Show,
    /// The distances that a picture of depth shows as white and as black.
    pub depths: Depths,
}

impl Picture<'_> {
    // ANCHOR: draw
    /// One ray for each sample of each pixel; `nearest` says what it hits, and counts its work.
    /// Whether normals are smooth is settled before the first ray, so what is left out costs
    /// nothing.
    pub fn draw<T: Tally>(
        &self,
        settings: &Settings,
        smooth: bool,
        nearest: impl Fn(&Ray, &mut T) -> Option<Found> + Sync,
    ) -> Rendering<T> {
        match smooth {
            true => self.draw_with::<T, true>(settings, nearest),
            false => self.draw_with::<T, false>(settings, nearest),
        }
    }

    fn draw_with<T: Tally, const SMOOTH: bool>(
        &self,
        settings: &Settings,
        nearest: impl Fn(&Ray, &mut T) -> Option<Found> + Sync,
    ) -> Rendering<T> {
        render_counted(settings, |pixel, sampler, tally: &mut T| {
            let ray = self.camera.ray(pixel.position(sampler));
            tally.count(CAMERA_RAYS, 1);
            match nearest(&ray, tally) {
                Some(found) => self.color::<T, SMOOTH>(&found, tally),
                None => self.background(),
            }
        })
    }
    // ANCHOR_END: draw

    /// The colour of a hit: its normal from [-1, 1] to [0, 1], or its distance between the limits.
    fn color<T: Tally, const SMOOTH: bool>(&self, found: &Found, tally: &mut T) -> Color {
        if self.show == Show::Depth {
            let Depths { near, far } = self.depths;
            return Color::splat(((far - found.hit.t) / (far - near)).clamp(0.0, 1.0));
        }
        if SMOOTH && !self.mesh.normals.is_empty() {
            tally.count(SMOOTH_NORMALS, 1);
        }
        let normal = surface::normal::<SMOOTH>(self.mesh, found.index, found.hit.barycentric);
        (normal + Vec3::ONE) / 2.0
    }

    fn background(&self) -> Color {
        match self.show {
            Show::Normals => BACKGROUND,
            Show::Depth => Color::ZERO,
        }
    }
}

/// The distances from an eye between which a mesh lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depths {
    /// To the nearest vertex.
    pub near: f32,
    /// To the farthest.
    pub far: f32,
}

impl Depths {
    /// Those of `mesh` from `eye`.
    pub fn of(mesh: &Mesh, eye: Vec3) -> Self {
        let distance = |place: &Vec3| (place.as_dvec3() - eye.as_dvec3()).length() as f32;
        let distances = mesh.positions.iter().map(distance);
        let nearest = distances.clone().fold(f32::INFINITY, f32::min);
        let far = distances.fold(0.0, f32::max);
        // The surface may come a little nearer than its vertices.
        Self { near: 0.9 * nearest, far }
    }
}

#[cfg(test)]
mod tests {
    use common::render::Settings;
    use common::tally::{Counts, Tally};
    use glam::Vec3;
    use ray_casting::camera::{CAMERA_RAYS, Camera, View};
    use ray_casting::picture::Show;

    use super::{Depths, Picture, SMOOTH_NORMALS};
    use crate::brute::TRIANGLE_TESTS;
    use crate::bumpy::sphere;
    use crate::lanes::Packed;
    use crate::mesh::Mesh;

    /// The picture's hash, and the smooth normals counted.
    fn drawn(mesh: &Mesh, show: Show, smooth: bool, threads: usize) -> (u64, u64) {
        let eye = Vec3::new(0.5, 1.0, 3.0);
        let view = View { eye, target: Vec3::ZERO, up: Vec3::Y, vertical_fov: 45.0 };
        let camera = Camera::new(&view, 40, 30).expect("an ordinary view");
        let picture = Picture { mesh, camera, show, depths: Depths::of(mesh, eye) };
        let settings = Settings { width: 40, height: 30, spp: 2, threads, ..Settings::default() };
        let packed = Packed::new(mesh.all_corners());
        let nearest = |ray: &_, tally: &mut Counts| {
            tally.count(TRIANGLE_TESTS, packed.len() as u64);
            packed.nearest(ray, f32::INFINITY)
        };
        let rendering = picture.draw::<Counts>(&settings, smooth, nearest);
        assert_eq!(rendering.tally.of(CAMERA_RAYS), 2400);
        assert_eq!(rendering.tally.of(TRIANGLE_TESTS), 2400 * mesh.triangles.len() as u64);
        assert_eq!(rendering.film.nonfinite, 0);
        (rendering.film.hash(), rendering.tally.of(SMOOTH_NORMALS))
    }

    #[test]
    fn what_is_not_called_for_changes_nothing_and_is_not_done() {
        let smooth = sphere(300);
        let flat = Mesh { normals: Vec::new(), ..smooth.clone() };
        assert_eq!(drawn(&flat, Show::Normals, true, 1), drawn(&flat, Show::Normals, false, 1));
        assert_eq!(drawn(&smooth, Show::Depth, true, 1), drawn(&smooth, Show::Depth, false, 1));
        let [all, none] = [true, false].map(|it| drawn(&smooth, Show::Normals, it, 1));
        assert!(all.0 != none.0 && all.1 > 0 && none.1 == 0, "the control: here it matters");
    }

    #[test]
    fn any_number_of_threads_draws_the_same_bits() {
        let mesh = sphere(300);
        let one = drawn(&mesh, Show::Normals, true, 1);
        assert!([2, 3, 7].iter().all(|&threads| drawn(&mesh, Show::Normals, true, threads) == one));
    }
}
