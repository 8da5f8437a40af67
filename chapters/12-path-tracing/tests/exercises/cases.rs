//! The inputs, and oracles by other formulas than the solutions'.

use common::film::Color;
use common::sampler::Stream;
use common::stats::estimate::Estimate;
use common::stats::running::Running;
use path_tracing::exercises::Tiny;
use path_tracing::naive::Intersection;
use path_tracing::part::Emission;

/// A direction that a matte surface chose.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight {
    pub(super) reflectance: f32,
    pub(super) cosine: f32,
    pub(super) pdf: f32,
}

pub(super) fn weights() -> Vec<Weight> {
    let weight = |reflectance, cosine, pdf| Weight { reflectance, cosine, pdf };
    let mut weights = vec![
        weight(0.5, 0.8, 0.8 * std::f32::consts::FRAC_1_PI),
        weight(0.5, 0.25, 0.5 * std::f32::consts::FRAC_1_PI),
        weight(0.7, -0.3, 0.1),
        weight(0.7, 0.0, 0.0),
        weight(0.0, 0.5, 0.2),
    ];
    for trial in 0..100 {
        let mut stream = Stream::of_trial(1281, trial);
        let cosine = stream.between(-0.2, 1.0);
        weights.push(weight(stream.between(0.1, 1.0), cosine, stream.between(0.01, 2.0)));
    }
    weights
}

impl Weight {
    pub(super) fn exact(&self) -> f32 {
        let [reflectance, cosine, pdf] = [self.reflectance, self.cosine, self.pdf].map(f64::from);
        if cosine <= 0.0 {
            return 0.0;
        }
        (reflectance * cosine / (std::f64::consts::PI * pdf)) as f32
    }
}

/// A furnace, and how deep paths may go in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    pub(super) albedo: f32,
    pub(super) depth: u32,
}

/// An estimator of a furnace's radiance.
pub(super) type Estimator = fn(f32, u32, &mut dyn FnMut() -> f32) -> f32;

pub(super) fn rooms() -> Vec<Room> {
    let room = |albedo, depth| Room { albedo, depth };
    vec![room(0.5, 0), room(0.5, 1), room(0.8, 1), room(0.8, 3), room(0.3, 5), room(1.0, 4)]
}

impl Room {
    pub(super) fn exact(&self) -> Estimate {
        let albedo = f64::from(self.albedo);
        Estimate::exact((0..=self.depth).map(|power| power_of(albedo, power)).sum())
    }

    pub(super) fn estimate(&self, answer: Estimator) -> Estimate {
        mean(1282, |random| answer(self.albedo, self.depth, random))
    }
}

fn power_of(base: f64, power: u32) -> f64 {
    (0..power).map(|_| base).product()
}

/// The mean of forty thousand answers.
fn mean(seed: u64, answer: impl Fn(&mut dyn FnMut() -> f32) -> f32) -> Estimate {
    let of = |trial| {
        let mut stream = Stream::of_trial(seed, trial);
        f64::from(answer(&mut || stream.uniform()))
    };
    let samples: Running = (0..40_000).map(of).collect();
    Estimate::of(&samples).expect("many samples")
}

/// Whether both can be the same number: by the z-test, or to the digits of `f32`, for an estimator
/// without noise.
pub(super) fn agree(expected: &Estimate, yours: &Estimate) -> bool {
    let close = (expected.mean - yours.mean).abs() <= 1e-5 * expected.mean.abs();
    // A right answer is refused once in 10⁶ cases; the seeds are fixed.
    close || expected.agrees(yours, 1e-6)
}

/// A tiny world, and how deep paths may go in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trip {
    pub(super) tiny: Tiny,
    pub(super) depth: u32,
}

/// An estimator of what the eye sees in a tiny world.
pub(super) type TinyEstimator = fn(&Tiny, u32, &mut dyn FnMut() -> f32) -> f32;

pub(super) fn trips() -> Vec<Trip> {
    let trip = |albedo, lamps: [f32; 2], skies: [f32; 2], depth| {
        let ([lamp_share, lamp], [sky_share, sky]) = (lamps, skies);
        let tiny = Tiny { albedo, lamp_share, lamp, sky_share, sky };
        Trip { tiny, depth }
    };
    vec![
        trip(0.5, [0.25, 4.0], [0.0, 0.0], 0),
        trip(0.5, [0.25, 4.0], [0.0, 0.0], 1),
        trip(0.8, [0.25, 1.0], [0.0, 0.0], 4),
        trip(0.8, [0.1, 5.0], [0.3, 0.5], 6),
        trip(0.9, [0.0, 3.0], [0.4, 2.0], 3),
        trip(0.9, [0.4, 1.0], [0.4, 4.0], 4),
    ]
}

impl Trip {
    /// Of what is met at each surface, the part that isn't lamp or sky is wall again.
    pub(super) fn exact(&self) -> Estimate {
        let Tiny { albedo, lamp_share, lamp, sky_share, sky } = self.tiny;
        let [albedo, lamp_share, lamp] = [albedo, lamp_share, lamp].map(f64::from);
        let [sky_share, sky] = [sky_share, sky].map(f64::from);
        let found = albedo * (lamp_share * lamp + sky_share * sky);
        let onward = albedo * (1.0 - lamp_share - sky_share);
        Estimate::exact((0..self.depth).map(|power| found * power_of(onward, power)).sum())
    }

    pub(super) fn estimate(&self, answer: TinyEstimator) -> Estimate {
        mean(1283, |random| answer(&self.tiny, self.depth, random))
    }
}

/// A camera's ray, and what there is.
#[derive(Clone, Debug)]
pub(super) struct Ray {
    pub(super) met: Intersection,
    pub(super) things: Vec<Emission>,
    pub(super) sky: Color,
}

pub(super) fn rays() -> Vec<Ray> {
    let glow = |radiance, both_sides| Emission { radiance: Color::splat(radiance), both_sides };
    let things = vec![glow(8.0, false), glow(0.0, false), glow(3.0, true)];
    let ray = |happened, thing, outgoing_z, things: &[Emission]| {
        let met = Intersection { happened, thing, outgoing_z };
        Ray { met, things: things.to_vec(), sky: Color::new(0.2, 0.4, 0.8) }
    };
    vec![
        ray(true, 0, 0.7, &things),
        ray(true, 1, 0.7, &things),
        ray(true, 2, -0.7, &things),
        ray(true, 0, -0.7, &things),
        ray(false, 0, 0.0, &things),
        ray(false, 0, 0.0, &things[1..]),
        ray(false, 0, 0.0, &[]),
    ]
}

impl Ray {
    pub(super) fn radiance(&self) -> Color {
        let thing = self.met.happened.then(|| self.things[self.met.thing]);
        thing.map_or(self.sky, |thing| {
            let seen = thing.both_sides || self.met.outgoing_z > 0.0;
            if seen { thing.radiance } else { Color::ZERO }
        })
    }
}

/// How much of a furnace's light may be missing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Depth {
    pub(super) albedo: f64,
    pub(super) missing: f64,
}

pub(super) fn depths() -> Vec<Depth> {
    let depth = |albedo, missing| Depth { albedo, missing };
    let mut depths = vec![
        depth(0.5, 0.3),
        depth(0.5, 0.01),
        depth(0.9, 0.01),
        depth(0.99, 0.001),
        depth(0.2, 0.5),
        depth(0.0, 0.1),
    ];
    for trial in 0..50 {
        let mut stream = Stream::of_trial(1285, trial);
        let albedo = f64::from(stream.between(0.05, 0.98));
        depths.push(depth(albedo, f64::from(stream.between(0.001, 0.5))));
    }
    depths.retain(|it| it.is_clear());
    depths
}

impl Depth {
    /// The power of the albedo, as a real number, at which just so much is missing.
    fn power(&self) -> f64 {
        libm::log(self.missing) / libm::log(self.albedo)
    }

    /// Whether no rounding can decide it.
    fn is_clear(&self) -> bool {
        (self.power() - self.power().round()).abs() > 1e-6 || self.albedo == 0.0
    }

    /// a^(depth + 1) is to be at most `missing`.
    pub(super) fn smallest(&self) -> u32 {
        if self.albedo == 0.0 {
            return 0;
        }
        (self.power().ceil() as u32).saturating_sub(1)
    }
}
