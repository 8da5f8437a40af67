//! The inputs, and what is right: in `f64`, and not by the solutions' formulas.

use common::sampler::Stream;
use glam::{DVec3, Vec3};
use whitted::exercises::Met;

pub(crate) fn direction(stream: &mut Stream) -> Vec3 {
    let mut component = || stream.between(-1.0, 1.0);
    let vector = Vec3::new(component(), component(), component());
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
}

/// A ray and the mirror it meets.
#[derive(Debug)]
pub(crate) struct Turn {
    pub(crate) incoming: Vec3,
    pub(crate) normal: Vec3,
}

impl Turn {
    /// By taking the direction apart along three axes, of which the mirror turns one round.
    pub(crate) fn mirrored(&self) -> Vec3 {
        let (incoming, normal) = (self.incoming.as_dvec3(), self.normal.as_dvec3().normalize());
        let (right, up) = normal.any_orthonormal_pair();
        let parts = DVec3::new(incoming.dot(right), incoming.dot(up), -incoming.dot(normal));
        (parts.x * right + parts.y * up + parts.z * normal).as_vec3()
    }
}

pub(crate) fn turns() -> Vec<Turn> {
    let by_hand = [
        (Vec3::new(2.0, -3.0, 6.0) / 7.0, Vec3::Y),
        (Vec3::new(2.0, -3.0, 6.0) / 7.0, Vec3::NEG_Y),
        (Vec3::NEG_Y, Vec3::new(0.6, 0.8, 0.0)),
    ];
    let random = (0..100).map(|trial| {
        let mut stream = Stream::of_trial(621, trial);
        (direction(&mut stream), direction(&mut stream))
    });
    let turn = |(incoming, normal)| Turn { incoming, normal };
    by_hand.into_iter().chain(random).map(turn).collect()
}

/// Surfaces in a row, and how far to follow.
#[derive(Debug)]
pub(crate) struct Way {
    pub(crate) surfaces: Vec<Met>,
    pub(crate) depth: u32,
    pub(crate) cutoff: f32,
}

impl Way {
    /// Each surface's share, from the product of all mirrors before it.
    pub(crate) fn radiance(&self) -> f32 {
        let share = |count: usize| -> f64 {
            self.surfaces[..count].iter().map(|met| f64::from(met.mirror)).product()
        };
        let reached = |&count: &usize| {
            count == 0 || (count as u32 <= self.depth && share(count) > f64::from(self.cutoff))
        };
        let counts = (0..self.surfaces.len()).take_while(reached);
        counts.map(|count| share(count) * f64::from(self.surfaces[count].light)).sum::<f64>() as f32
    }
}

pub(crate) fn ways() -> Vec<Way> {
    let met = |light, mirror| Met { light, mirror };
    let mut ways = vec![
        Way { surfaces: vec![met(3.0, 0.5)], depth: 4, cutoff: 0.0 },
        Way { surfaces: vec![met(3.0, 0.5), met(8.0, 0.25)], depth: 1, cutoff: 0.0 },
        Way {
            surfaces: vec![met(3.0, 0.5), met(8.0, 0.25), met(16.0, 0.0)],
            depth: 1,
            cutoff: 0.0,
        },
        Way { surfaces: vec![met(3.0, 0.5), met(8.0, 0.25)], depth: 0, cutoff: 0.0 },
        Way { surfaces: vec![met(1.0, 0.5); 4], depth: 9, cutoff: 0.2 },
    ];
    for trial in 0..100 {
        let mut stream = Stream::of_trial(622, trial);
        let count = 1 + stream.bits() % 9;
        let surfaces =
            (0..count).map(|_| met(stream.between(0.1, 4.0), stream.between(0.3, 1.0))).collect();
        let (depth, cutoff) = (stream.bits() % 9, stream.between(0.0, 0.5));
        ways.push(Way { surfaces, depth, cutoff });
    }
    ways
}

/// Two facing mirrors, and how much may be missing.
#[derive(Debug)]
pub(crate) struct Mirrors {
    pub(crate) mirror: f64,
    pub(crate) missing: f64,
}

impl Mirrors {
    /// By adding up mirrors until what is shown is enough.
    pub(crate) fn depth(&self) -> u32 {
        let all = 1.0 / (1.0 - self.mirror);
        let (mut shown, mut next) = (1.0, self.mirror);
        let mut depth = 0;
        while all - shown > self.missing * all {
            shown += next;
            next *= self.mirror;
            depth += 1;
        }
        depth
    }
}

pub(crate) fn mirrors() -> Vec<Mirrors> {
    // None lies so near a whole depth that roundings would decide.
    let pairs = [
        (0.5, 0.3),
        (0.5, 0.1),
        (0.9, 0.1),
        (0.9, 0.01),
        (0.8, 0.003),
        (0.3, 0.5),
        (0.99, 0.002),
        (0.95, 0.7),
        (0.2, 0.9),
        (0.997, 1e-4),
    ];
    pairs.map(|(mirror, missing)| Mirrors { mirror, missing }).into()
}

/// A ray that leaves a mirror, and the step it has to take.
#[derive(Debug)]
pub(crate) struct Start {
    pub(crate) point: Vec3,
    pub(crate) normal: Vec3,
    pub(crate) direction: Vec3,
    pub(crate) epsilon: f32,
}

impl Start {
    /// By the plane of the mirror: of the two points beside it, the one on the ray's side.
    pub(crate) fn origin(&self) -> Vec3 {
        let point = self.point.as_dvec3();
        let step = f64::from(self.epsilon) * self.normal.as_dvec3();
        let ahead = point + self.direction.as_dvec3();
        let nearer = |candidate: &DVec3| (*candidate - ahead).length();
        let sides = [point + step, point - step];
        let [one, other] = sides.each_ref().map(nearer);
        if one < other { sides[0].as_vec3() } else { sides[1].as_vec3() }
    }
}

pub(crate) fn starts() -> Vec<Start> {
    let start = |trial| {
        let mut stream = Stream::of_trial(626, trial);
        let mut place = || stream.between(-4.0, 6.0);
        let point = Vec3::new(place(), place(), place());
        let (normal, direction) = (direction(&mut stream), direction(&mut stream));
        Start { point, normal, direction, epsilon: 0.25 + stream.uniform() / 4.0 }
    };
    (0..60).map(start).collect()
}
