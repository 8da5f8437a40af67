//! Triangles, rays at them, and what each ray hits.

use std::hint::black_box;

use common::cost::Method;
use common::tally::{Counts, Off};
use glam::{Vec2, Vec3};
use ray_casting::camera::{Camera, View};
use ray_casting::ray::Ray;
use triangles::brute::{Found, TRIANGLE_TESTS};
use triangles::bumpy;
use triangles::scene::BUNNY_VIEW;

use crate::accelerator::{Accelerator, CELL_STEPS, NODE_VISITS};
use crate::scan::Scan;

/// Triangles, rays at them, and what each ray hits by the linear scan.
pub(super) struct Sight {
    pub(super) triangles: Vec<[Vec3; 3]>,
    rays: Vec<Ray>,
    hits: Vec<Option<Found>>,
}

const SPHERE_VIEW: View =
    View { eye: Vec3::new(0.6, 1.2, 3.2), target: Vec3::ZERO, up: Vec3::Y, vertical_fov: 42.0 };

/// What the error of a method is here.
pub(super) const ERROR: &str = "share of rays whose hit is not that of the linear scan, to the bit";

impl Sight {
    /// The bunny as the report sees it.
    pub(super) fn bunny(triangles: Vec<[Vec3; 3]>) -> Self {
        Self::new(triangles, &BUNNY_VIEW)
    }

    /// A bumpy sphere that fills most of the picture.
    pub(super) fn sphere(triangles: u32) -> Self {
        Self::new(bumpy::sphere(triangles).all_corners(), &SPHERE_VIEW)
    }

    fn new(triangles: Vec<[Vec3; 3]>, view: &View) -> Self {
        let camera = Camera::new(view, 40, 30).expect("both views are ordinary");
        let pixels =
            (0..30).flat_map(|y| (0..40).map(move |x| Vec2::new(x as f32, y as f32) + 0.5));
        let rays: Vec<Ray> = pixels.map(|position| camera.ray(position)).collect();
        let scan = Scan::build(triangles.clone());
        let hits = rays.iter().map(|ray| scan.nearest(ray, f32::INFINITY, &mut Off)).collect();
        Self { triangles, rays, hits }
    }

    /// How many rays there are.
    pub(super) fn rays(&self) -> u64 {
        self.rays.len() as u64
    }

    /// Tests and steps of all rays together.
    pub(super) fn work(&self, accelerator: &impl Accelerator) -> u64 {
        let mut counts = Counts::default();
        for ray in &self.rays {
            accelerator.nearest(ray, f32::INFINITY, &mut counts);
        }
        [TRIANGLE_TESTS, CELL_STEPS, NODE_VISITS].map(|event| counts.of(event)).iter().sum()
    }

    /// The share of rays that are told something else than by the scan.
    fn error(&self, accelerator: &impl Accelerator) -> f64 {
        let found = self.rays.iter().map(|ray| accelerator.nearest(ray, f32::INFINITY, &mut Off));
        let wrong = found.zip(&self.hits).filter(|(found, hit)| found != *hit).count();
        wrong as f64 / self.rays.len() as f64
    }

    /// The method that finds what each ray hits by `accelerator`.
    pub(super) fn method(
        &self,
        accelerator: impl Accelerator + 'static,
        series: &'static str,
        label: String,
        size: f64,
        work: u64,
    ) -> Method<'static> {
        let (error, rays) = (self.error(&accelerator), self.rays.clone());
        let run = move || {
            for ray in &rays {
                black_box(accelerator.nearest(black_box(ray), f32::INFINITY, &mut Off));
            }
        };
        Method { label, series, size, work, error, run: Box::new(run) }
    }
}
