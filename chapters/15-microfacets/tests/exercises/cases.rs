//! The inputs, and oracles in `f64` by other formulas than the solutions'.

use std::f64::consts::{PI, TAU};

use common::sampler::Stream;
use common::stats::estimate::Estimate;
use common::stats::running::Running;
use glam::{DVec3, Vec2, Vec3};

/// The direction whose height is `z`, turned by `turn`.
fn at(z: f32, turn: f32) -> Vec3 {
    let radius = ((1.0 - z) * (1.0 + z)).sqrt();
    Vec3::new(radius * common::math::cos(turn), radius * common::math::sin(turn), z)
}

/// A facet of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    pub(super) alpha: f32,
    pub(super) normal: Vec3,
}

pub(super) fn facets() -> Vec<Facet> {
    let mut facets = vec![
        Facet { alpha: 1.0, normal: Vec3::Z },
        Facet { alpha: 0.5, normal: Vec3::Z },
        Facet { alpha: 0.5, normal: Vec3::new(0.6, 0.0, 0.8) },
        Facet { alpha: 0.2, normal: Vec3::new(0.28, 0.0, 0.96) },
    ];
    for trial in 0..200 {
        let mut stream = Stream::of_trial(1541, trial);
        let alpha = common::math::pow(10.0, stream.between(-4.0, 0.0));
        let slope = stream.between(0.0, 5.0) * alpha;
        let turn = stream.between(0.0, 6.0);
        let (x, y) = (common::math::cos(turn), common::math::sin(turn));
        let normal = Vec3::new(slope * x, slope * y, 1.0).normalize();
        facets.push(Facet { alpha, normal });
    }
    facets
}

impl Facet {
    /// As Walter and others print it: α² / (π cos⁴θ (α² + tan²θ)²).
    pub(super) fn density(&self) -> f32 {
        let normal = self.normal.as_dvec3().normalize();
        let square = f64::from(self.alpha) * f64::from(self.alpha);
        let cosine_squared = normal.z * normal.z;
        let slope = normal.truncate().length_squared() / cosine_squared;
        let spread = cosine_squared * (square + slope);
        (square / (PI * spread * spread)) as f32
    }
}

/// Two directions above a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub(super) alpha: f32,
    pub(super) outgoing: Vec3,
    pub(super) incoming: Vec3,
}

pub(super) fn pairs() -> Vec<Pair> {
    let pair = |alpha, outgoing, incoming| Pair { alpha, outgoing, incoming };
    let mut pairs = vec![
        pair(1.0, Vec3::Z, Vec3::new(0.6, 0.0, 0.8)),
        pair(0.5, Vec3::new(0.0, 0.6, 0.8), Vec3::new(0.6, 0.0, 0.8)),
        pair(0.5, Vec3::new(0.0, 0.8, 0.6), Vec3::new(0.96, 0.0, 0.28)),
    ];
    for trial in 0..200 {
        let mut stream = Stream::of_trial(1542, trial);
        let alpha = stream.between(0.1, 1.0);
        let mut direction = || at(stream.between(0.01, 1.0), stream.between(0.0, 6.0));
        pairs.push(pair(alpha, direction(), direction()));
    }
    pairs
}

impl Pair {
    /// 1 / (1 + Λ + Λ'), with the tangents from the angles.
    pub(super) fn both(&self) -> f32 {
        let lambda = |direction: Vec3| {
            let angle =
                libm::atan2(direction.as_dvec3().truncate().length(), f64::from(direction.z));
            let slope = f64::from(self.alpha) * libm::tan(angle);
            ((1.0 + slope * slope).sqrt() - 1.0) / 2.0
        };
        (1.0 / (1.0 + lambda(self.outgoing) + lambda(self.incoming))) as f32
    }
}

/// A surface and from where it is seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub(super) alpha: f32,
    pub(super) outgoing: Vec3,
}

/// The means of the three coordinates of normals.
#[derive(Clone, Copy, Debug)]
pub(super) struct Means {
    x: Estimate,
    y: Estimate,
    z: Estimate,
}

impl Means {
    pub(super) fn agree(&self, other: &Self, significance: f64) -> bool {
        let pairs = [(self.x, other.x), (self.y, other.y), (self.z, other.z)];
        pairs.iter().all(|(one, other)| one.agrees(other, significance))
    }
}

pub(super) fn views() -> Vec<View> {
    let view = |alpha, z, turn| View { alpha, outgoing: at(z, turn) };
    vec![view(1.0, 1.0, 0.0), view(0.5, 0.6, 0.0), view(0.3, 0.2, 1.0), view(0.8, 0.1, 4.0)]
}

impl View {
    /// The integrals of the coordinates times G₁ (outgoing · normal) D / cosθ, over tanθ / α and the
    /// turn.
    pub(super) fn means(&self) -> Means {
        const STEPS: u32 = 600;
        let (alpha, outgoing) = (f64::from(self.alpha), self.outgoing.as_dvec3());
        let middle = |step: u32| (f64::from(step) + 0.5) / f64::from(STEPS);
        let (mut sum, mut total) = (DVec3::ZERO, 0.0);
        for (i, j) in (0..STEPS).flat_map(|i| (0..STEPS).map(move |j| (i, j))) {
            let radius = alpha * (middle(i) / (1.0 - middle(i))).sqrt();
            let (sine, cosine) = libm::sincos(TAU * middle(j));
            let normal = DVec3::new(radius * cosine, radius * sine, 1.0).normalize();
            // D cosθ is in the steps; of the rest all that is constant cancels in the mean.
            let share = outgoing.dot(normal).max(0.0) / normal.z;
            sum += share * normal;
            total += share;
        }
        let mean = sum / total;
        let [x, y, z] = mean.to_array().map(|mean| Estimate { mean, standard_error: 2e-4 });
        Means { x, y, z }
    }

    /// The means over ten thousand answers.
    pub(super) fn estimate(&self, answer: fn(f32, Vec3, Vec2) -> Vec3) -> Means {
        let mut samples = [Running::default(); 3];
        for trial in 0..10_000 {
            let u = Stream::of_trial(1543, trial).uniform2();
            let normal = answer(self.alpha, self.outgoing, u).to_array();
            for (samples, part) in samples.iter_mut().zip(normal) {
                samples.add(f64::from(part));
            }
        }
        let [x, y, z] = samples.map(|samples| Estimate::of(&samples).expect("many samples"));
        Means { x, y, z }
    }
}

/// A surface of roughness 1 under a sky of radiance 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sky {
    pub(super) cosine: f32,
}

pub(super) fn skies() -> Vec<Sky> {
    [1.0, 0.8, 0.5, 0.25, 0.1].map(|cosine| Sky { cosine }).to_vec()
}

impl Sky {
    pub(super) fn exact(&self) -> Estimate {
        let cosine = f64::from(self.cosine);
        Estimate::exact(1.0 - cosine * libm::log((1.0 + cosine) / cosine))
    }

    /// The mean of twenty thousand answers.
    pub(super) fn estimate(&self, answer: fn(f32, Vec2) -> f32) -> Estimate {
        let of = |trial| f64::from(answer(self.cosine, Stream::of_trial(1544, trial).uniform2()));
        let samples: Running = (0..20_000).map(of).collect();
        Estimate::of(&samples).expect("many samples")
    }
}

/// A facet that reflects.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) outgoing: Vec3,
    pub(super) normal: Vec3,
    pub(super) density: f32,
}

pub(super) fn turns() -> Vec<Turn> {
    let mut turns =
        vec![Turn { outgoing: Vec3::Z, normal: Vec3::new(0.6, 0.0, 0.8), density: 1.0 }];
    for trial in 0..100 {
        let mut stream = Stream::of_trial(1545, trial);
        let outgoing = at(stream.between(0.1, 1.0), stream.between(0.0, 6.0));
        let normal = at(stream.between(0.3, 1.0), stream.between(0.0, 6.0));
        turns.push(Turn { outgoing, normal, density: stream.between(0.1, 5.0) });
    }
    turns.retain(|turn| turn.outgoing.dot(turn.normal) > 0.1);
    turns
}

impl Turn {
    /// By moving the normal a little in two directions and measuring what the reflected direction
    /// sweeps.
    pub(super) fn density(&self) -> f32 {
        const STEP: f64 = 1e-5;
        let (outgoing, normal) = (self.outgoing.as_dvec3(), self.normal.as_dvec3().normalize());
        let first = normal.any_orthonormal_vector();
        let second = normal.cross(first);
        let reflected = |normal: DVec3| 2.0 * outgoing.dot(normal) * normal - outgoing;
        let moved = |step: DVec3| reflected((normal + STEP * step).normalize());
        let [x, y] = [first, second].map(|step| (moved(step) - moved(-step)) / (2.0 * STEP));
        (f64::from(self.density) / x.cross(y).length()) as f32
    }
}
