//! What the exercises are asked, and the right answers: closed forms.

use common::film::Color;
use common::sampler::Stream;
use common::stats::estimate::Estimate;
use common::stats::running::Running;
use russian_roulette::roulette::LEAST;

/// Estimates whose mean is taken.
const TRIALS: u64 = 40_000;

/// The mean of an answer over many trials.
fn mean(seed: u64, answer: impl Fn(&mut Stream) -> f64) -> Estimate {
    let samples = (0..TRIALS).map(|trial| answer(&mut Stream::of_trial(seed, trial)));
    let samples: Running = samples.collect();
    Estimate::of(&samples).unwrap_or(Estimate::exact(f64::NAN))
}

/// Light that is asked for now and then.
#[derive(Debug)]
pub(super) struct Light {
    radiance: f32,
    survival: f32,
}

pub(super) fn lights() -> Vec<Light> {
    let light = |radiance, survival| Light { radiance, survival };
    vec![light(3.0, 0.8), light(2.0, 0.25), light(0.1, 0.5), light(5.0, 1.0)]
}

impl Light {
    pub(super) fn expected(&self) -> Estimate {
        Estimate::exact(self.radiance.into())
    }

    pub(super) fn mean(&self, estimate: fn(f32, f32, f32) -> f32) -> Estimate {
        let found =
            mean(1, |stream| estimate(self.radiance, self.survival, stream.uniform()).into());
        // What is always the same has been rounded, and no noise hides that.
        Estimate { standard_error: found.standard_error.max(1e-6), ..found }
    }
}

/// A furnace, and how often paths go on in it.
#[derive(Debug)]
pub(super) struct Room {
    pub(super) albedo: f32,
    pub(super) survival: f32,
}

pub(super) fn rooms() -> Vec<Room> {
    let room = |albedo, survival| Room { albedo, survival };
    vec![room(0.5, 0.5), room(0.5, 0.8), room(0.8, 0.8), room(0.2, 0.4), room(0.9, 0.95)]
}

pub(super) fn rooms_and_worse() -> Vec<Room> {
    let mut rooms = rooms();
    let worse = [(0.5, 0.125), (0.9, 0.75), (0.5, 1.0)];
    rooms.extend(worse.map(|(albedo, survival)| Room { albedo, survival }));
    rooms
}

impl Room {
    pub(super) fn expected(&self) -> Estimate {
        Estimate::exact(1.0 / (1.0 - f64::from(self.albedo)))
    }

    pub(super) fn mean(&self, furnace: fn(f32, f32, &mut Stream) -> f32) -> Estimate {
        mean(2, |stream| furnace(self.albedo, self.survival, stream).into())
    }

    /// From all lengths a path may have, one after the other.
    pub(super) fn variance(&self) -> Option<f64> {
        let (albedo, survival) = (f64::from(self.albedo), f64::from(self.survival));
        if albedo * albedo >= survival {
            return None;
        }
        let mean = 1.0 / (1.0 - albedo);
        if survival == 1.0 {
            return Some(0.0);
        }
        let (mut sum, mut brought, mut carried, mut probability) = (0.0, 1.0, 1.0, 1.0);
        for _ in 0..4000 {
            let apart: f64 = brought - mean;
            sum += probability * (1.0 - survival) * apart * apart;
            probability *= survival;
            carried *= albedo / survival;
            brought += carried;
        }
        Some(sum)
    }
}

/// Whether two variances are the same, or both infinite.
pub(super) fn alike(expected: Option<f64>, yours: Option<f64>) -> bool {
    match (expected, yours) {
        (Some(expected), Some(yours)) => {
            expected.to_bits() == yours.to_bits()
                || (expected - yours).abs() <= 1e-6 * expected.abs().max(1e-3)
        }
        (None, None) => true,
        _ => false,
    }
}

/// What a path carries.
#[derive(Debug)]
pub(super) struct Load {
    pub(super) throughput: Color,
    pub(super) threshold: f32,
}

pub(super) fn loads() -> Vec<Load> {
    let load =
        |red, green, blue, threshold| Load { throughput: Color::new(red, green, blue), threshold };
    vec![
        load(0.5, 0.25, 0.125, 1.0),
        load(0.25, 0.25, 0.25, 0.5),
        load(0.0, 0.0, 0.25, 1.0),
        load(3.0, 0.5, 0.5, 2.0),
        load(0.0, 0.0, 0.0, 0.5),
        load(1e-10, 1e-12, 0.0, 1.0),
        load(1e-40, 0.0, 0.0, 0.5),
    ]
}

impl Load {
    pub(super) fn survival(&self) -> f32 {
        let Self { throughput, threshold } = self;
        let parts = throughput.to_array().map(|part| f64::from(part) / f64::from(*threshold));
        let largest = parts.into_iter().fold(0.0, f64::max);
        if largest == 0.0 { 0.0 } else { largest.min(1.0).max(LEAST.into()) as f32 }
    }
}

/// Whether two probabilities are the same, as far as it matters. NaN is NaN.
pub(super) fn same(expected: f32, yours: f32) -> bool {
    expected.is_nan() && yours.is_nan() || (expected - yours).abs() <= 1e-6 * expected
}

/// A furnace with coloured walls.
#[derive(Debug)]
pub(super) struct ColoredRoom {
    albedo: Color,
    threshold: f32,
}

pub(super) fn colored_rooms() -> Vec<ColoredRoom> {
    let room = |red, green, blue, threshold| ColoredRoom {
        albedo: Color::new(red, green, blue),
        threshold,
    };
    vec![room(0.5, 0.5, 0.5, 0.5), room(0.63, 0.065, 0.05, 0.5), room(0.8, 0.4, 0.0, 1.0)]
}

impl ColoredRoom {
    pub(super) fn expected(&self) -> [Estimate; 3] {
        self.albedo.to_array().map(|part| Estimate::exact(1.0 / (1.0 - f64::from(part))))
    }

    pub(super) fn mean(&self, colored: fn(Color, f32, &mut Stream) -> Color) -> [Estimate; 3] {
        let mut parts = [Running::default(); 3];
        for trial in 0..TRIALS {
            let mut stream = Stream::of_trial(5, trial);
            let found = colored(self.albedo, self.threshold, &mut stream);
            for (part, found) in parts.iter_mut().zip(found.to_array()) {
                part.add(found.into());
            }
        }
        parts.map(|part| {
            let found = Estimate::of(&part).unwrap_or(Estimate::exact(f64::NAN));
            // What is always the same has been rounded, and no noise hides that.
            Estimate { standard_error: found.standard_error.max(1e-6), ..found }
        })
    }
}
