//! Means of more and more samples, as curves.

use common::film::Color;
use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use glam::Vec2;

use crate::command::SAMPLES;
use crate::points::Points;
use crate::sky;

/// Curves, each of other random numbers.
const CURVES: u64 = 24;
/// A curve goes on to this power of two.
const DOUBLINGS: u32 = 12;
/// Points of a curve for each doubling.
const STEPS: u32 = 16;
/// From the middle of the chart to its edge, in parts of the answer.
const REACH: f64 = 0.5;
/// Half a line's width, in parts of the picture's height.
const HALF_WIDTH: f32 = 0.0025;

/// To the right the number of samples, from 1 to 4096, by doublings; up, their mean, from half of
/// the answer to one and a half. Each blue curve is another mean of the sky's light; the orange ones
/// are the answer, and that plus and minus one standard deviation of a mean of random samples.
pub struct Funnel {
    curves: Vec<Vec<f32>>,
}

impl Funnel {
    /// The chart for one kind of points.
    pub fn new(points: Points, seed: u64) -> Self {
        let seeds = (0..CURVES).map(|curve| seed.wrapping_mul(CURVES).wrapping_add(curve));
        Self { curves: seeds.map(|seed| curve(points, seed)).collect() }
    }

    /// The chart. No ray is followed for it.
    pub fn draw<T: Tally>(&self, settings: &Settings) -> Rendering<T> {
        let size = Vec2::new(settings.width as f32, settings.height as f32);
        let aspect = size.x / size.y;
        let mut rendering: Rendering<T> = render_counted(settings, |pixel, sampler, _tally| {
            let place = pixel.position(sampler) / size;
            let place = Vec2::new(place.x, 1.0 - place.y);
            let blue = Color::new(0.05, 0.2, 0.6);
            let paper = self.curves.iter().fold(grid(place), |under, curve| {
                under.lerp(blue, 0.7 * ink(place, aspect, |x| along(curve, x)))
            });
            [-1.0, 0.0, 1.0].into_iter().fold(paper, |under, deviations| {
                let ink = ink(place, aspect, |x| band(x, deviations));
                under.lerp(Color::new(0.85, 0.22, 0.0), ink)
            })
        });
        rendering.tally.count(SAMPLES, CURVES << DOUBLINGS);
        rendering
    }
}

/// The means of the first samples at each step, as heights in the chart.
fn curve(points: Points, seed: u64) -> Vec<f32> {
    let most = 1 << DOUBLINGS;
    let (mut sum, mut done) = (0.0, 0);
    let steps = (0..=DOUBLINGS * STEPS).map(|step| samples(step as f32 / STEPS as f32));
    let mean = |count: u32| {
        while done < count {
            sum += sky::uniform(points.at(done, most, seed)).estimate();
            done += 1;
        }
        height(sum / f64::from(done))
    };
    steps.map(mean).collect()
}

/// The number of samples after so many doublings, at least 1.
fn samples(doublings: f32) -> u32 {
    (common::math::pow(2.0, doublings) + 0.5) as u32
}

/// Where a mean is, from 0 at the bottom to 1.
fn height(mean: f64) -> f32 {
    (0.5 + (mean / sky::IRRADIANCE - 1.0) / (2.0 * REACH)) as f32
}

/// A curve at the part x of its width.
fn along(curve: &[f32], x: f32) -> f32 {
    let place = x.clamp(0.0, 1.0) * (curve.len() - 1) as f32;
    let left = (place as usize).min(curve.len() - 2);
    let part = place - left as f32;
    curve[left] * (1.0 - part) + curve[left + 1] * part
}

/// The answer and so many standard deviations of a mean.
fn band(x: f32, deviations: f64) -> f32 {
    let count = f64::from(common::math::pow(2.0, x.clamp(0.0, 1.0) * DOUBLINGS as f32));
    height(sky::IRRADIANCE + deviations * (sky::UNIFORM_VARIANCE / count).sqrt())
}

/// How dark a line of this curve makes a place.
fn ink(place: Vec2, aspect: f32, curve: impl Fn(f32) -> f32) -> f32 {
    let step = HALF_WIDTH / aspect;
    let (here, next) = (curve(place.x), curve(place.x + step));
    let steepness = (next - here) / HALF_WIDTH;
    let distance = (here - place.y).abs() / (1.0 + steepness * steepness).sqrt();
    (1.5 - distance / HALF_WIDTH).clamp(0.0, 1.0)
}

/// White paper with a line at each second doubling and each tenth of the answer.
fn grid(place: Vec2) -> Color {
    let apart = (place * Vec2::new(DOUBLINGS as f32 / 2.0, 10.0) + 0.5).fract() - 0.5;
    let on_line = apart.abs().min_element() < 0.015;
    Color::splat(if on_line { 0.8 } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::{Funnel, band, height};
    use crate::points::Points;
    use crate::sky;

    #[test]
    fn means_end_near_the_answer() {
        assert_eq!(height(sky::IRRADIANCE), 0.5);
        for points in Points::ALL {
            let funnel = Funnel::new(points, 1);
            for curve in &funnel.curves {
                // Five standard deviations.
                let reach = 5.0 * (band(1.0, 1.0) - 0.5);
                assert!((curve[curve.len() - 1] - 0.5).abs() < reach, "{points:?}");
            }
        }
    }
}
