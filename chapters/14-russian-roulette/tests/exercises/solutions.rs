//! One good answer to each exercise.

use common::film::Color;
use common::sampler::Stream;

pub(super) fn estimate(radiance: f32, survival: f32, chance: f32) -> f32 {
    if chance < survival { radiance / survival } else { 0.0 }
}

pub(super) fn furnace(albedo: f32, survival: f32, chances: &mut Stream) -> f32 {
    let (mut radiance, mut throughput) = (1.0, 1.0);
    while chances.uniform() < survival {
        throughput *= albedo / survival;
        radiance += throughput;
    }
    radiance
}

pub(super) fn variance(albedo: f64, survival: f64) -> Option<f64> {
    let mean = 1.0 / (1.0 - albedo);
    let ratio = albedo * albedo / survival;
    (ratio < 1.0).then(|| (1.0 + 2.0 * albedo * mean) / (1.0 - ratio) - mean * mean)
}

pub(super) fn survival(throughput: Color, threshold: f32) -> f32 {
    let brightest = throughput.max_element();
    if brightest == 0.0 { 0.0 } else { (brightest / threshold).clamp(1.0 / 4096.0, 1.0) }
}

pub(super) fn colored(albedo: Color, threshold: f32, chances: &mut Stream) -> Color {
    let (mut radiance, mut throughput) = (Color::ZERO, Color::ONE);
    loop {
        radiance += throughput;
        throughput *= albedo;
        let probability = survival(throughput, threshold);
        if chances.uniform() >= probability {
            return radiance;
        }
        throughput /= probability;
    }
}

pub(super) fn go_on(survival: f32, chance: f32) -> Option<f32> {
    (chance < survival).then(|| 1.0 / survival)
}
