//! MI-05: the density of a direction, asked for again where a path came upon the lamp.

use common::film::Color;
use common::hard::{Case, UNLIMITED};
use common::math::pow;
use common::sampler::Stream;
use common::tally::Off;
use fresnel::conductor::Metal;
use glam::Vec3;
use light_sampling::lamp::Way;
use light_sampling::lights::{Choice, LightSample, Lights};
use light_sampling::naive::cap_height;
use microfacets::rough::Rough;
use monte_carlo::frame::Frame;
use path_tracing::bsdf::Bsdf;
use path_tracing::part::{Emission, Form, Part};
use path_tracing::random::Random;
use path_tracing::space::{Met, Space};
use path_tracing::world::Surface;
use ray_casting::ray::Ray;

use super::CHAPTER;

/// MI-05: a ball near and far, and rough metal.
pub(super) const MET_AGAIN: Case = Case {
    id: "MI-05",
    chapter: CHAPTER,
    input: "the density of what a path met, against that of the sample",
    most: UNLIMITED,
    naive_fails: |trial| {
        let Some(sight) = Sight::new(trial) else { return false };
        let Sight { sample, distance, .. } = sight;
        let again = 1.0 / (std::f32::consts::TAU * cap_height(distance));
        differ(sample.pdf, again, 1e-3)
    },
    robust_fails: |trial| lamp_differs(trial) || metal_differs(trial),
};

/// A ball that was looked at, and met in the same direction.
struct Sight {
    lights: Lights,
    sample: LightSample,
    met: Met,
    from: Vec3,
    /// To its centre, in radii.
    distance: f32,
}

impl Sight {
    /// `None` where the ray passed by: at the rim, rounding may carry it past.
    fn new(trial: u64) -> Option<Self> {
        let mut stream = Stream::of_trial(1603, trial);
        let radius = pow(10.0, stream.between(-2.0, 2.0));
        let distance = pow(10.0, stream.between(0.01, 4.0));
        let toward = point(&mut stream).normalize();
        let from = 10.0 * point(&mut stream);
        let ball = Form::ball(from + distance * radius * toward, radius);
        let emission = Emission { radiance: Color::ONE, both_sides: false };
        let material = Rough::metal(Metal::GOLD, 0.2);
        let space = Space::new(&[Part { form: ball, material, emission }]);
        let surfaces = [Surface { bsdf: material, emission }];
        let lights = Lights::new(&space, &surfaces, Choice::Power, Way::SolidAngle);
        let sample = lights.sample(from, &Random::of_trial(1604, trial))?;
        let ray = Ray { origin: from, direction: sample.point.direction };
        let met = space.nearest(&ray, &mut Off)?;
        Some(Self { lights, sample, met, from, distance })
    }
}

fn lamp_differs(trial: u64) -> bool {
    Sight::new(trial).is_some_and(|sight| {
        differ(sight.sample.pdf, sight.lights.pdf(sight.from, &sight.met), 1e-3)
    })
}

/// Rough metal whose sample went through the world's axes and back.
fn metal_differs(trial: u64) -> bool {
    let mut stream = Stream::of_trial(1605, trial);
    let alpha = pow(10.0, stream.between(-2.0, 0.0));
    let metal = Rough::metal(Metal::GOLD, alpha);
    let up = point(&mut stream).normalize();
    let outgoing = up.with_z(up.z.abs().max(0.01)).normalize();
    let Some(sample) = metal.sample(outgoing, &Random::of_trial(1606, trial)) else { return false };
    let frame = Frame::around(point(&mut stream).normalize());
    let world = frame.to_world(sample.incoming);
    let back = frame.to_local(world / world.length());
    // At grazing angles, a rounding of the direction is a larger part of its height.
    let tolerance = 1e-3 * (1.0 + 0.01 / sample.incoming.z);
    differ(sample.pdf, metal.pdf(outgoing, back), tolerance)
}

/// Whether it is another density, or one of the two is 0.
fn differ(sampled: f32, again: f32, tolerance: f32) -> bool {
    !(again > 0.0 && (again / sampled - 1.0).abs() <= tolerance)
}

/// A point of the cube from -1 to 1, not too near its middle.
fn point(stream: &mut Stream) -> Vec3 {
    let point = Vec3::from_array([(); 3].map(|()| stream.between(-1.0, 1.0)));
    if point.length() > 0.1 { point } else { point + Vec3::splat(0.3) }
}
