//! The bunny behind no box, one, and many.

use std::hint::black_box;
use std::sync::Arc;

use common::cost::{Experiment, Method, Plot, Table};
use common::tally::Off;
use glam::{Vec2, Vec3};
use ray_casting::camera::Camera;
use ray_casting::ray::Ray;
use triangles::brute::Found;
use triangles::bunny::bunny;
use triangles::convert::Normals;
use triangles::lanes::Packed;
use triangles::scene::BUNNY_VIEW;

use crate::parts::Parts;

const COLUMNS: u32 = 40;
const ROWS: u32 = 30;

/// Chapter 2's picture of the bunny, small, with more and more boxes.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let corners = bunny(Normals::Flat).ok()?.all_corners();
    let camera = Camera::new(&BUNNY_VIEW, COLUMNS, ROWS).ok()?;
    let pixels = (0..ROWS).flat_map(|y| (0..COLUMNS).map(move |x| (x, y)));
    let centre = |(x, y): (u32, u32)| Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
    let rays: Arc<Vec<Ray>> = Arc::new(pixels.map(|pixel| camera.ray(centre(pixel))).collect());
    let packed = Packed::new(corners.clone());
    let brute = rays.iter().map(|ray| packed.nearest(ray, f32::INFINITY)).collect();
    let right: Arc<Vec<Option<Found>>> = Arc::new(brute);
    let mut methods = vec![method("none".into(), "no box", 1, &rays, &right, move |ray| {
        packed.nearest(ray, f32::INFINITY)
    })];
    methods.extend([1, 4, 16, 64, 256, 1024].map(|count| boxed(&corners, count, &rays, &right)));
    Some(Experiment {
        name: "bunny",
        title: "The bunny behind boxes, each around as many triangles",
        work_unit: "rays",
        error_metric: "rays whose nearest triangle or t isn't that of brute force",
        plot: Plot::TimeOver("boxes"),
        methods,
        note,
    })
}

fn boxed(
    corners: &[[Vec3; 3]],
    count: u32,
    rays: &Arc<Vec<Ray>>,
    right: &Arc<Vec<Option<Found>>>,
) -> Method<'static> {
    let parts = Parts::new(corners, count as usize);
    method(count.to_string(), "boxes", count, rays, right, move |ray| {
        parts.nearest(ray, f32::INFINITY, &mut Off)
    })
}

fn method(
    label: String,
    series: &'static str,
    count: u32,
    rays: &Arc<Vec<Ray>>,
    right: &[Option<Found>],
    nearest: impl Fn(&Ray) -> Option<Found> + 'static,
) -> Method<'static> {
    let wrong = rays.iter().zip(right).filter(|(ray, right)| nearest(ray) != **right);
    let (error, rays) = (wrong.count() as f64, rays.clone());
    Method {
        label,
        series,
        size: f64::from(count),
        work: rays.len() as u64,
        error,
        run: Box::new(move || {
            for ray in rays.iter() {
                black_box(nearest(black_box(ray)));
            }
        }),
    }
}

fn note(table: &Table) -> String {
    let time = |label: &str| {
        let row = table.rows.iter().find(|row| row.label == label);
        row.map_or(f64::NAN, |row| row.time.median)
    };
    let least = table.rows.iter().fold(f64::INFINITY, |least, row| least.min(row.time.median));
    let (one, best) = (time("none") / time("1"), time("none") / least);
    format!("One box makes it {one:.1} times as fast, the best number of boxes {best:.1} times.")
}
