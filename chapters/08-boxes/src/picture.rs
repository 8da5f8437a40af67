//! What each pixel shows: the nearest triangle, the boxes, or the work it took.

use common::film::Color;
use common::render::{Rendering, Settings, render_counted};
use common::tally::{Counts, Event, Tally};
use glam::Vec3;
use ray_casting::camera::{CAMERA_RAYS, Camera};
use ray_casting::picture::BACKGROUND;
use ray_casting::ray::Ray;
use triangles::brute::{Found, TRIANGLE_TESTS};
use triangles::mesh::Mesh;
use triangles::picture::SMOOTH_NORMALS;
use triangles::surface;

use crate::aabb::Aabb;
use crate::slab::BOX_TESTS;
use crate::wires;

/// What is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Show {
    /// Which way the surface faces, and the edges of the boxes around it
    #[default]
    Boxes,
    /// Which way the surface faces, as in chapter 2
    Normals,
    /// The work: black for none, white for all that brute force does
    Work,
}

/// A mesh, its boxes, and the camera they are seen with.
pub struct Picture<'a> {
    /// What there is to see.
    pub mesh: &'a Mesh,
    /// The boxes whose edges are drawn over it.
    pub boxes: &'a [Aabb],
    /// How thick the edges are.
    pub thickness: f32,
    /// Where from.
    pub camera: Camera,
    /// What of it.
    pub show: Show,
}

/// What one ray took. It is counted apart from the picture's tally, which may be off.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    boxes: u64,
    triangles: u64,
}

impl Tally for Work {
    fn count(&mut self, event: Event, times: u64) {
        if event == BOX_TESTS {
            self.boxes += times;
        } else if event == TRIANGLE_TESTS {
            self.triangles += times;
        }
    }

    fn counts(&mut self) -> Option<&mut Counts> {
        None
    }

    fn merge(&mut self, other: &Self) {
        self.boxes += other.boxes;
        self.triangles += other.triangles;
    }
}

impl Picture<'_> {
    /// One ray for each sample of each pixel; `nearest` says what it hits, and counts its work.
    pub fn draw<T: Tally>(
        &self,
        settings: &Settings,
        smooth: bool,
        nearest: impl Fn(&Ray, &mut Work) -> Option<Found> + Sync,
    ) -> Rendering<T> {
        match smooth {
            true => self.draw_with::<T, true>(settings, nearest),
            false => self.draw_with::<T, false>(settings, nearest),
        }
    }

    fn draw_with<T: Tally, const SMOOTH: bool>(
        &self,
        settings: &Settings,
        nearest: impl Fn(&Ray, &mut Work) -> Option<Found> + Sync,
    ) -> Rendering<T> {
        render_counted(settings, |pixel, sampler, tally: &mut T| {
            let ray = self.camera.ray(pixel.position(sampler));
            let mut work = Work::default();
            let found = nearest(&ray, &mut work);
            tally.count(CAMERA_RAYS, 1);
            tally.count(BOX_TESTS, work.boxes);
            tally.count(TRIANGLE_TESTS, work.triangles);
            let limit = found.map_or(f32::INFINITY, |found| found.hit.t);
            match self.show {
                Show::Work => self.heat(&work),
                Show::Normals => self.surface::<T, SMOOTH>(found, tally),
                Show::Boxes => {
                    let seen = self.surface::<T, SMOOTH>(found, tally);
                    wires::over(seen, self.boxes, self.thickness, &ray, limit)
                }
            }
        })
    }

    /// The normal from [-1, 1] to [0, 1], as in chapter 2; the background where nothing is hit.
    fn surface<T: Tally, const SMOOTH: bool>(&self, found: Option<Found>, tally: &mut T) -> Color {
        let Some(Found { hit, index }) = found else { return BACKGROUND };
        if SMOOTH && !self.mesh.normals.is_empty() {
            tally.count(SMOOTH_NORMALS, 1);
        }
        (surface::normal::<SMOOTH>(self.mesh, index, hit.barycentric) + Vec3::ONE) / 2.0
    }

    /// Black, red, yellow, white: the tests made, as a share of those that brute force makes.
    fn heat(&self, work: &Work) -> Color {
        let all = self.mesh.triangles.len().max(1) as f32;
        let share = ((work.boxes + work.triangles) as f32 / all).min(1.0);
        (3.0 * share - Vec3::new(0.0, 1.0, 2.0)).clamp(Vec3::ZERO, Vec3::ONE)
    }
}
