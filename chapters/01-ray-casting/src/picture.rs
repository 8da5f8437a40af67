//! What each pixel shows of the nearest hit.

use common::film::Color;
use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use glam::{Vec2, Vec3};

use crate::camera::{CAMERA_RAYS, Camera};
use crate::naive;
use crate::ray::Ray;
use crate::scene::Geometry;
use crate::shape::{Hit, nearest};

/// What is shown of a hit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Show {
    /// Which way the surface faces: x, y and z as red, green and blue.
    #[default]
    Normals,
    /// How far away it is: white is near, black is far.
    Depth,
}

/// The report's background, behind everything.
pub const BACKGROUND: Color = Color::new(0.235_294, 0.674_51, 0.843_137);

/// A scene, the camera it is seen with, and what is to be shown.
#[derive(Clone, Copy)]
pub struct Picture<'a> {
    /// What there is to see.
    pub geometry: &'a Geometry,
    /// Where from.
    pub camera: Camera,
    /// What of it.
    pub show: Show,
}

impl Picture<'_> {
    // ANCHOR: draw
    /// One ray for each sample of each pixel; `ray_of` says which.
    pub fn draw<T: Tally>(
        &self,
        settings: &Settings,
        ray_of: impl Fn(Vec2) -> Ray + Sync,
    ) -> Rendering<T> {
        render_counted(settings, |pixel, sampler, tally: &mut T| {
            let ray = ray_of(pixel.position(sampler));
            tally.count(CAMERA_RAYS, 1);
            let found = nearest(&self.geometry.shapes, &ray, tally);
            found.map_or(self.background(), |found| self.color(&found.hit))
        })
    }
    // ANCHOR_END: draw

    /// The picture of nothing, for which no ray is needed.
    pub fn draw_nothing<T: Tally>(&self, settings: &Settings) -> Rendering<T> {
        render_counted(settings, |_pixel, _sampler, _tally| self.background())
    }

    // ANCHOR: color
    /// The colour of a hit: its normal from [-1, 1] to [0, 1], or its distance between the limits.
    fn color(&self, hit: &Hit) -> Color {
        match self.show {
            Show::Normals => (hit.normal + Vec3::ONE) / 2.0,
            Show::Depth => {
                let [near, far] = self.geometry.depths;
                Color::splat(((far - hit.t) / (far - near)).clamp(0.0, 1.0))
            }
        }
    }
    // ANCHOR_END: color

    fn background(&self) -> Color {
        match self.show {
            Show::Normals => BACKGROUND,
            Show::Depth => Color::ZERO,
        }
    }
}

/// The ray that the report's §5.1 gives for a point of this camera's film.
pub fn report_ray(camera: &Camera, position: Vec2) -> Ray {
    naive::report_ray(position, camera.size(), camera.eye(), camera.tangent())
}
