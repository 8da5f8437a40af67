//! What accuracy costs: how far to follow, how to follow, and what the plan saves.

mod following;
mod kaleidoscope;
mod plan;
mod series;

use common::cost::Experiment;
use glam::Vec2;
use ray_casting::camera::Camera;
use ray_casting::ray::Ray;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let scenes = [series::experiment(), kaleidoscope::experiment(), plan::experiment()];
    std::iter::once(following::experiment()).chain(scenes.into_iter().flatten()).collect()
}

/// A ray through the centre of each pixel.
fn rays(camera: &Camera, width: u32, height: u32) -> Vec<Ray> {
    let camera = camera.with_film(width, height);
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| Vec2::new(x as f32, y as f32)));
    pixels.map(|pixel| camera.ray(pixel + 0.5)).collect()
}

/// The root of the mean of the squares.
fn root_mean_square(errors: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0);
    for error in errors {
        sum += error * error;
        count += 1;
    }
    (sum / f64::from(count)).sqrt()
}
