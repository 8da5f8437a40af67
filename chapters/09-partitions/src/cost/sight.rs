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

/// Triangles, rays at them, and what some of the rays hit by the linear scan.
pub struct Sight {
    /// The triangles.
    pub triangles: Vec<[Vec3; 3]>,
    rays: Vec<Ray>,
    /// Of one ray in so many the hit is known.
    step: usize,
    hits: Vec<Option<Found>>,
}

const SPHERE_VIEW: View =
    View { eye: Vec3::new(0.6, 1.2, 3.2), target: Vec3::ZERO, up: Vec3::Y, vertical_fov: 42.0 };

/// What the error of a method is here.
pub const ERROR: &str = "share of rays whose hit is not that of the linear scan, to the bit";

impl Sight {
    /// The bunny as the report sees it.
    pub fn bunny(triangles: Vec<[Vec3; 3]>) -> Self {
        Self::new(triangles, &BUNNY_VIEW, 1)
    }

    /// A bumpy sphere that fills most of the picture.
    pub fn sphere(triangles: u32) -> Self {
        Self::large_sphere(triangles, 1)
    }

    /// The same for so many triangles that only one ray in `step` can be checked by the scan.
    pub fn large_sphere(triangles: u32, step: usize) -> Self {
        Self::new(bumpy::sphere(triangles).all_corners(), &SPHERE_VIEW, step)
    }

    fn new(triangles: Vec<[Vec3; 3]>, view: &View, step: usize) -> Self {
        let camera = Camera::new(view, 40, 30).expect("both views are ordinary");
        let pixels =
            (0..30).flat_map(|y| (0..40).map(move |x| Vec2::new(x as f32, y as f32) + 0.5));
        let rays: Vec<Ray> = pixels.map(|position| camera.ray(position)).collect();
        let scan = Scan::build(triangles.clone());
        let checked = rays.iter().step_by(step);
        let hits = checked.map(|ray| scan.nearest(ray, f32::INFINITY, &mut Off)).collect();
        Self { triangles, rays, step, hits }
    }

    /// How many rays there are.
    pub fn rays(&self) -> u64 {
        self.rays.len() as u64
    }

    /// Tests and steps of all rays together.
    pub fn work(&self, accelerator: &impl Accelerator) -> u64 {
        let mut counts = Counts::default();
        for ray in &self.rays {
            accelerator.nearest(ray, f32::INFINITY, &mut counts);
        }
        [TRIANGLE_TESTS, CELL_STEPS, NODE_VISITS].map(|event| counts.of(event)).iter().sum()
    }

    /// The share of the checked rays that are told something else than by the scan.
    fn error(&self, accelerator: &impl Accelerator) -> f64 {
        let checked = self.rays.iter().step_by(self.step);
        let found = checked.map(|ray| accelerator.nearest(ray, f32::INFINITY, &mut Off));
        let wrong = found.zip(&self.hits).filter(|(found, hit)| found != *hit).count();
        wrong as f64 / self.hits.len() as f64
    }

    /// The method that finds what each ray hits by `accelerator`.
    pub fn method(
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
