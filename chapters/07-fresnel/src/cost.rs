//! What accuracy costs in time.

mod by_hand;
mod pictures;
mod plan;
mod reflectances;
mod schlick;

use common::cost::Experiment;
use glam::Vec2;
use ray_casting::ray::Ray;

use crate::interface::Interface;
use crate::scenes::Stage;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let formulas = [reflectances::experiment(), schlick::over_indices(), schlick::over_angles()];
    let scenes = [pictures::formulas(), pictures::branching(), plan::experiment()];
    formulas.into_iter().chain(scenes.into_iter().flatten()).collect()
}

/// A ray through the centre of each pixel.
fn rays(stage: &Stage, width: u32, height: u32) -> Vec<Ray> {
    let camera = stage.camera.with_film(width, height);
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| Vec2::new(x as f32, y as f32)));
    pixels.map(|pixel| camera.ray(pixel + 0.5)).collect()
}

/// Fresnel's equations in `f64` with the cosine beyond from the sine: plain, and independent of the
/// forms that are measured.
fn by_sines(interface: &Interface, cosine: f64) -> f64 {
    let ratio = interface.ratio();
    let sine = ratio * (1.0 - cosine * cosine).sqrt();
    if sine >= 1.0 {
        return 1.0;
    }
    let beyond = (1.0 - sine * sine).sqrt();
    let perpendicular = (ratio * cosine - beyond) / (ratio * cosine + beyond);
    let parallel = (cosine - ratio * beyond) / (cosine + ratio * beyond);
    (perpendicular * perpendicular + parallel * parallel) / 2.0
}

/// The root of the mean of the squares.
fn root_mean_square(errors: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for error in errors {
        sum += error * error;
        count += 1.0;
    }
    (sum / f64::max(count, 1.0)).sqrt()
}
