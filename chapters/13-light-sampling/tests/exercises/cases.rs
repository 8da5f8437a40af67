//! The inputs, and oracles in `f64` by other formulas than the solutions'.

use std::f64::consts::PI;

use common::film::Color;
use common::sampler::Stream;
use common::stats::estimate::Estimate;
use common::stats::running::Running;
use glam::{DVec3, Vec2, Vec3};
use light_sampling::polygon;

/// A point of a lamp.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) distance: f32,
    pub(super) cosine: f32,
    pub(super) area: f32,
}

pub(super) fn spots() -> Vec<Spot> {
    let spot = |distance, cosine, area| Spot { distance, cosine, area };
    let mut spots = vec![spot(1.0, 1.0, 1.0), spot(5.0, 0.8, 3.0), spot(2.0, 0.5, 0.25)];
    for trial in 0..100 {
        let mut stream = Stream::of_trial(1360, trial);
        let mut number = |low, high| stream.between(low, high);
        spots.push(spot(number(0.1, 20.0), number(0.05, 1.0), number(0.1, 9.0)));
    }
    spots
}

impl Spot {
    /// One over the solid angle of the whole lamp, were it as small and as far as this piece of it: a
    /// thousandth of it as wide, seen as a disc that is turned away.
    pub(super) fn density(&self) -> f32 {
        let [distance, cosine, area] = [self.distance, self.cosine, self.area].map(f64::from);
        let piece = 1e-12 * area;
        let seen = piece * cosine;
        // The cap of a disc of this area: 2π (1 - cos), with tan² = area / (π distance²).
        let square = seen / (PI * distance * distance);
        let cap = 2.0 * PI * square / (1.0 + square + (1.0 + square).sqrt());
        (1e-12 / cap) as f32
    }
}

/// A lamp over a surface at the origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scene {
    normal: Vec3,
    albedo: f32,
    corners: [Vec3; 3],
    radiance: f32,
}

/// A reader's estimator.
pub(super) type Direct = fn(Vec3, f32, [Vec3; 3], f32, Vec2) -> f32;

pub(super) fn scenes() -> Vec<Scene> {
    let level = [[-1.0, 0.5, 3.0], [2.0, 1.5, 3.0], [0.5, -2.0, 3.0]].map(Vec3::from_array);
    let [a, b, c] = level;
    let tilted = [[1.0, 0.0, 0.2], [2.5, 0.0, 1.0], [1.0, 1.5, 2.0]].map(Vec3::from_array);
    let cut = [[2.0, -1.0, -1.0], [2.0, 1.0, -0.5], [1.5, 0.3, 2.0]].map(Vec3::from_array);
    let scene = |corners, albedo, radiance| Scene { normal: Vec3::Z, albedo, corners, radiance };
    let mut scenes = vec![scene([a, b, c], 0.5, 8.0), scene([a, c, b], 0.5, 8.0)];
    for [a, b, c] in [tilted, cut] {
        scenes.push(scene([a, b, c], 0.8, 3.0));
        scenes.push(scene([a, c, b], 0.8, 3.0));
    }
    let leaning = Vec3::new(0.6, 0.0, 0.8);
    scenes.push(Scene { normal: leaning, ..scene([a, b, c], 0.3, 2.0) });
    scenes
}

impl Scene {
    /// Lambert's closed form, where the bright side is seen.
    pub(super) fn exact(&self) -> Estimate {
        let [a, b, c] = self.corners.map(Vec3::as_dvec3);
        let faces = (b - a).cross(c - a).dot(a) < 0.0;
        let (normal, albedo) = (self.normal.as_dvec3(), f64::from(self.albedo));
        let radiance = polygon::radiance(&[a, b, c], normal, albedo) * f64::from(self.radiance);
        Estimate::exact(if faces { radiance } else { 0.0 })
    }

    /// The mean of twenty thousand answers.
    pub(super) fn estimate(&self, answer: Direct) -> Estimate {
        let &Self { normal, albedo, corners, radiance } = self;
        let of = |trial| {
            let u = Stream::of_trial(1361, trial).uniform2();
            f64::from(answer(normal, albedo, corners, radiance, u))
        };
        let samples: Running = (0..20_000).map(of).collect();
        Estimate::of(&samples).expect("many samples")
    }
}

/// A ball of light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub(super) distance: f32,
    pub(super) radius: f32,
}

pub(super) fn balls() -> Vec<Ball> {
    let ball = |distance, radius| Ball { distance, radius };
    let mut balls =
        vec![ball(1.25, 1.0), ball(10.0, 6.0), ball(100.0, 1.0), ball(5e3, 1.0), ball(2e6, 2.0)];
    for trial in 0..100 {
        let mut stream = Stream::of_trial(1362, trial);
        let radius = stream.between(0.1, 3.0);
        let far = common::math::pow(10.0, stream.between(0.05, 6.0));
        balls.push(ball(far * radius, radius));
    }
    balls
}

impl Ball {
    /// The cap's solid angle is 4π sin²(θ / 2).
    pub(super) fn density(&self) -> f32 {
        let angle = libm::asin(f64::from(self.radius) / f64::from(self.distance));
        let half = libm::sin(angle / 2.0);
        (1.0 / (4.0 * PI * half * half)) as f32
    }
}

/// Some lamps, of which one is to be looked at.
#[derive(Clone, Debug)]
pub(super) struct Many {
    powers: Vec<f32>,
    lights: Vec<f32>,
}

/// A reader's estimator.
pub(super) type OneLamp = fn(&[f32], &[f32], f32) -> f32;

pub(super) fn many() -> Vec<Many> {
    let many =
        |powers: &[f32], lights: &[f32]| Many { powers: powers.into(), lights: lights.into() };
    vec![
        many(&[1.0, 3.0], &[2.0, 3.0]),
        many(&[5.0, 1.0, 2.0], &[1.0, 4.0, 0.5]),
        many(&[0.0, 2.0, 0.0, 6.0, 0.0], &[0.0, 1.0, 0.0, 1.5, 0.0]),
        many(&[4.0], &[7.0]),
        many(&[1.0, 1.0, 1.0, 13.0], &[0.2, 0.0, 0.1, 5.0]),
    ]
}

impl Many {
    pub(super) fn exact(&self) -> Estimate {
        Estimate::exact(self.lights.iter().map(|&light| f64::from(light)).sum())
    }

    /// The mean of twenty thousand answers, to some ten roundings. The first number is 0, which comes
    /// up once in 2²⁴ times: a lamp without power must not be chosen even then.
    pub(super) fn estimate(&self, answer: OneLamp) -> Estimate {
        let chance = |trial| match trial {
            0 => 0.0,
            _ => Stream::of_trial(1363, trial).uniform(),
        };
        let of = |trial| f64::from(answer(&self.powers, &self.lights, chance(trial)));
        let samples: Running = (0..20_000).map(of).collect();
        let Estimate { mean, standard_error } = Estimate::of(&samples).expect("many samples");
        Estimate { mean, standard_error: standard_error.max(1e-6 * mean.abs()) }
    }
}

/// How a path came upon a lamp.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arrival {
    pub(super) from_eye: bool,
    pub(super) from_mirror: bool,
    pub(super) is_chosen: bool,
}

pub(super) fn arrivals() -> Vec<Arrival> {
    let arrival = |from_eye, from_mirror, is_chosen| Arrival { from_eye, from_mirror, is_chosen };
    let flags = [true, false];
    let ways = [(true, false), (false, true), (false, false)];
    let all = ways.into_iter().flat_map(|(eye, mirror)| flags.map(|it| arrival(eye, mirror, it)));
    all.collect()
}

impl Arrival {
    /// A table: what is looked for at a matte surface is what was chosen.
    pub(super) fn share(&self) -> f32 {
        match (self.from_eye, self.from_mirror, self.is_chosen) {
            (false, false, true) => 0.0,
            _ => 1.0,
        }
    }
}

/// A point of a lamp, and a surface that it shines on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weighed {
    pub(super) radiance: Color,
    pub(super) brdf: Color,
    pub(super) cosine: f32,
    pub(super) lamp_cosine: f32,
    pub(super) distance: f32,
    pub(super) density: f32,
}

pub(super) fn weighed() -> Vec<Weighed> {
    let mut weighed = Vec::new();
    for trial in 0..100 {
        let mut stream = Stream::of_trial(1364, trial);
        let mut number = |low, high| stream.between(low, high);
        let radiance = Color::new(number(0.1, 9.0), number(0.1, 9.0), number(0.1, 9.0));
        let brdf = Color::new(number(0.05, 0.3), number(0.05, 0.3), number(0.05, 0.3));
        let (cosine, lamp_cosine) = (number(0.1, 1.0), number(-0.5, 1.0));
        let (distance, density) = (number(0.3, 9.0), number(0.1, 5.0));
        weighed.push(Weighed { radiance, brdf, cosine, lamp_cosine, distance, density });
    }
    weighed
}

/// A reader's line.
pub(super) type Light = fn(Color, Color, f32, f32, f32, f32) -> Color;

impl Weighed {
    pub(super) fn of(&self, line: Light) -> Color {
        let &Self { radiance, brdf, cosine, lamp_cosine, distance, density } = self;
        line(radiance, brdf, cosine, lamp_cosine, distance, density)
    }

    /// The light of a lamp that is as large as one over the density, by its solid angle.
    pub(super) fn light(&self) -> Color {
        let [cosine, lamp_cosine, distance, density] =
            [self.cosine, self.lamp_cosine, self.distance, self.density].map(f64::from);
        let area = 1.0 / density;
        let solid_angle = area * lamp_cosine.max(0.0) / (distance * distance);
        let light: DVec3 = self.radiance.as_dvec3() * self.brdf.as_dvec3();
        (light * cosine * solid_angle).as_vec3()
    }
}
