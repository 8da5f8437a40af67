//! The inputs, and the right answers in closed form.

use common::sampler::Stream;
use common::stats::estimate::Estimate;
use common::stats::running::Running;
use glam::{DVec3, Vec2, Vec3};

/// How many answers a mean is made of.
const SAMPLES: u64 = 20_000;

/// The mean of many answers.
fn mean_of(seed: u64, answer: impl Fn(Vec2) -> f32) -> Estimate {
    let of = |trial| f64::from(answer(Stream::of_trial(seed, trial).uniform2()));
    let samples: Running = (0..SAMPLES).map(of).collect();
    Estimate::of(&samples).expect("many samples")
}

/// What is averaged over points of the disk.
#[derive(Clone, Copy, Debug)]
pub(super) enum Feature {
    /// The square of the radius.
    Square,
    /// Its fourth power.
    Fourth,
    X,
    Y,
    /// The part of the points in a quarter of the disk.
    Quarter,
    /// The part of the points that are outside of the disk, but for rounding.
    Outside,
}

pub(super) fn features() -> Vec<Feature> {
    let [x, y] = [Feature::X, Feature::Y];
    vec![Feature::Outside, Feature::Square, Feature::Fourth, x, y, Feature::Quarter]
}

impl Feature {
    /// The mean of r² is 1/2, that of r⁴ 1/3: r² is uniform.
    pub(super) fn exact(&self) -> Estimate {
        Estimate::exact(match self {
            Self::Square => 0.5,
            Self::Fourth => 1.0 / 3.0,
            Self::X | Self::Y | Self::Outside => 0.0,
            Self::Quarter => 0.25,
        })
    }

    pub(super) fn estimate(&self, disk: fn(Vec2) -> Vec2) -> Estimate {
        let number = |yes: bool| if yes { 1.0 } else { 0.0 };
        mean_of(1140, |u| {
            let point = disk(u);
            let square = point.length_squared();
            match self {
                Self::Square => square,
                Self::Fourth => square * square,
                Self::X => point.x,
                Self::Y => point.y,
                Self::Quarter => number(point.x > 0.0 && point.y > 0.0),
                Self::Outside => number(square > 1.000_001),
            }
        })
    }
}

/// A sky, and its irradiance.
#[derive(Clone, Copy)]
pub(super) struct Sky {
    name: &'static str,
    radiance: fn(Vec3) -> f32,
    exact: f64,
}

impl std::fmt::Debug for Sky {
    fn fmt(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(out, "a sky of radiance {}", self.name)
    }
}

pub(super) fn skies() -> Vec<Sky> {
    use std::f64::consts::PI;
    let sky = |name, radiance, exact| Sky { name, radiance, exact };
    vec![
        sky("1", |_| 1.0, PI),
        sky("z", |direction| direction.z, 2.0 * PI / 3.0),
        sky("2 where x is above 0", |it| if it.x > 0.0 { 2.0 } else { 0.0 }, PI),
        sky("(1 + 2 z)/3", |direction| (1.0 + 2.0 * direction.z) / 3.0, 7.0 * PI / 9.0),
        sky("y^2", |direction| direction.y * direction.y, PI / 4.0),
    ]
}

impl Sky {
    pub(super) fn exact(&self) -> Estimate {
        Estimate::exact(self.exact)
    }

    pub(super) fn estimate(&self, irradiance: fn(Vec2, fn(Vec3) -> f32) -> f32) -> Estimate {
        let estimate = mean_of(1141, |u| irradiance(u, self.radiance));
        // Cosines estimate the first sky without noise, to a rounding or two.
        let rounding = 1e-6 * estimate.mean.abs();
        Estimate { standard_error: estimate.standard_error.max(rounding), ..estimate }
    }
}

/// An answer to exercise 11.3.
type OverTriangle = fn([Vec3; 3], Vec2, fn(Vec3) -> f32) -> f32;

/// A triangle, and what is integrated over it: the second power asks for squares of estimates.
#[derive(Clone, Copy)]
pub(super) struct Patch {
    corners: [Vec3; 3],
    name: &'static str,
    value: fn(Vec3) -> f32,
    /// The means of the value and of its square over the triangle.
    means: fn([DVec3; 3]) -> [f64; 2],
    squared: bool,
}

impl std::fmt::Debug for Patch {
    fn fmt(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
        let what = if self.squared { "the square of an estimate" } else { "the integral" };
        write!(out, "{what} of {} over {:?}", self.name, self.corners)
    }
}

/// The mean of the square of a linear function with these values at the corners.
fn mean_square(corners: [f64; 3]) -> f64 {
    let [a, b, c] = corners;
    (a * a + b * b + c * c + a * b + b * c + c * a) / 6.0
}

pub(super) fn patches() -> Vec<Patch> {
    let corners = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(4.0, 1.0, 0.0), Vec3::new(0.5, 2.0, 2.0)];
    let patch = |name, value, means, squared| Patch { corners, name, value, means, squared };
    let one: fn(Vec3) -> f32 = |_| 1.0;
    let x: fn(Vec3) -> f32 = |point| point.x;
    let y: fn(Vec3) -> f32 = |point| point.y;
    let of_x: fn([DVec3; 3]) -> [f64; 2] = |corners| linear(corners.map(|corner| corner.x));
    let of_y: fn([DVec3; 3]) -> [f64; 2] = |corners| linear(corners.map(|corner| corner.y));
    vec![
        patch("1", one, |_| [1.0, 1.0], false),
        patch("x", x, of_x, false),
        patch("y", y, of_y, false),
        patch("x", x, of_x, true),
        patch("y", y, of_y, true),
    ]
}

fn linear(corners: [f64; 3]) -> [f64; 2] {
    [corners.iter().sum::<f64>() / 3.0, mean_square(corners)]
}

impl Patch {
    pub(super) fn exact(&self) -> Estimate {
        let [a, b, c] = self.corners.map(Vec3::as_dvec3);
        let area = (b - a).cross(c - a).length() / 2.0;
        let [mean, square] = (self.means)([a, b, c]);
        Estimate::exact(if self.squared { area * area * square } else { area * mean })
    }

    pub(super) fn estimate(&self, over: OverTriangle) -> Estimate {
        let estimate = mean_of(1142, |u| {
            let one = over(self.corners, u, self.value);
            if self.squared { one * one } else { one }
        });
        let rounding = 1e-6 * estimate.mean.abs();
        Estimate { standard_error: estimate.standard_error.max(rounding), ..estimate }
    }
}

/// Values of which one is to be looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Choice {
    weights: &'static [f32],
    values: &'static [f32],
    squared: bool,
}

pub(super) fn choices() -> Vec<Choice> {
    let lists: [(&[f32], &[f32]); 4] = [
        (&[1.0], &[5.0]),
        (&[1.0, 3.0], &[2.0, 3.0]),
        (&[0.0, 2.0, 5.0, 0.0, 1.0], &[0.0, 1.0, 7.0, 0.0, 2.0]),
        (&[0.2, 0.3, 0.1], &[1.0, 1.0, 4.0]),
    ];
    let both = |(weights, values)| [false, true].map(|squared| Choice { weights, values, squared });
    lists.into_iter().flat_map(both).collect()
}

impl Choice {
    /// The sum; and for squares, the sum of value² / probability.
    pub(super) fn exact(&self) -> Estimate {
        let total: f64 = self.weights.iter().map(|&weight| f64::from(weight)).sum();
        let pairs = self.weights.iter().zip(self.values).filter(|(weight, _)| **weight > 0.0);
        let square = |(&weight, &value): (&f32, &f32)| {
            f64::from(value) * f64::from(value) * total / f64::from(weight)
        };
        let sum: f64 = self.values.iter().map(|&value| f64::from(value)).sum();
        Estimate::exact(if self.squared { pairs.map(square).sum() } else { sum })
    }

    pub(super) fn estimate(&self, one: fn(&[f32], &[f32], f32) -> f32) -> Estimate {
        let estimate = mean_of(1143, |u| {
            // A few are an end of the interval, where lists go wrong; too few to change a mean.
            let u = if u.y < 2e-4 { 0.0 } else { u.x };
            let one = one(self.weights, self.values, u);
            if self.squared { one * one } else { one }
        });
        let rounding = 1e-6 * estimate.mean.abs();
        Estimate { standard_error: estimate.standard_error.max(rounding), ..estimate }
    }
}

/// Lists of samples around 0, 100, and so on.
pub(super) fn lists() -> Vec<Vec<f32>> {
    let list = |(trial, (offset, count)): (usize, (f32, usize))| {
        let mut stream = Stream::of_trial(1144, trial as u64);
        (0..count).map(|_| offset + stream.uniform()).collect()
    };
    let sizes = [(0.0, 2), (0.0, 50), (-3.0, 7), (100.0, 1000), (10_000.0, 30)];
    let by_hand = vec![2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0];
    std::iter::once(by_hand).chain(sizes.into_iter().enumerate().map(list)).collect()
}

/// By all pairs: the mean of half the squares of their differences.
pub(super) fn variance(samples: &[f32]) -> f64 {
    let count = samples.len() as f64;
    let square = |one: f32, other: f32| {
        let difference = f64::from(one) - f64::from(other);
        difference * difference
    };
    let of = |&one: &f32| samples.iter().map(|&other| square(one, other)).sum::<f64>();
    samples.iter().map(of).sum::<f64>() / (2.0 * count * (count - 1.0))
}
