//! The inputs, and oracles in `f64` by other formulas than the solutions'.

use common::film::Color;
use common::sampler::Stream;
use common::stats::estimate::Estimate;
use common::stats::running::Running;
use glam::Vec3;

/// A ray upon an interface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    pub(super) near: f32,
    pub(super) far: f32,
    pub(super) cosine: f32,
}

/// A few by hand, then others. None is so near the critical angle that `f32` can't decide.
pub(super) fn surfaces() -> Vec<Surface> {
    let surface = |near, far, cosine| Surface { near, far, cosine };
    let mut surfaces = vec![
        surface(1.0, 1.5, 1.0),
        surface(1.0, 1.5, 0.8),
        surface(1.5, 1.0, 0.9),
        surface(1.5, 1.0, 0.3),
        surface(1.33, 1.5, 0.25),
        surface(2.42, 1.33, 0.9),
    ];
    for trial in 0..200 {
        let mut stream = Stream::of_trial(740, trial);
        let (near, far) = (stream.between(1.0, 2.5), stream.between(1.0, 2.5));
        let cosine = stream.between(0.02, 1.0);
        surfaces.push(surface(near, far, cosine));
    }
    surfaces.retain(|it| (it.far_sine() - 1.0).abs() > 1e-3 && (it.near - it.far).abs() > 0.01);
    surfaces
}

impl Surface {
    /// The sine beyond, above 1 where there is none.
    fn far_sine(&self) -> f64 {
        let cosine = f64::from(self.cosine);
        f64::from(self.near) / f64::from(self.far) * (1.0 - cosine * cosine).sqrt()
    }

    pub(super) fn far_cosine(&self) -> Option<f32> {
        let sine = self.far_sine();
        (sine < 1.0).then(|| (1.0 - sine * sine).sqrt() as f32)
    }

    /// Fresnel's own form: with sines and tangents of the difference and the sum of the angles.
    /// Straight on they divide nothing by nothing, and there the part is known.
    pub(super) fn reflectance(&self) -> f32 {
        let sine = self.far_sine();
        if sine >= 1.0 {
            return 1.0;
        }
        if self.cosine == 1.0 {
            return self.straight() as f32;
        }
        let (one, other) = (libm::acos(f64::from(self.cosine)), libm::asin(sine));
        let perpendicular = libm::sin(one - other) / libm::sin(one + other);
        let parallel = libm::tan(one - other) / libm::tan(one + other);
        ((perpendicular * perpendicular + parallel * parallel) / 2.0) as f32
    }

    fn straight(&self) -> f64 {
        let (near, far) = (f64::from(self.near), f64::from(self.far));
        ((near - far) / (near + far)) * ((near - far) / (near + far))
    }

    pub(super) fn schlick(&self) -> f32 {
        let sine = self.far_sine();
        if sine >= 1.0 {
            return 1.0;
        }
        let larger = libm::acos(f64::from(self.cosine)).max(libm::asin(sine));
        let straight = self.straight();
        (straight + (1.0 - straight) * libm::pow(1.0 - libm::cos(larger), 5.0)) as f32
    }
}

/// A ray upon the surface of a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bend {
    pub(super) incoming: Vec3,
    pub(super) outward: Vec3,
    pub(super) index: f32,
}

pub(super) fn bends() -> Vec<Bend> {
    let bend =
        |x: f32, y: f32, outward, index| Bend { incoming: Vec3::new(x, y, 0.0), outward, index };
    let mut bends = vec![
        bend(0.0, -1.0, Vec3::Y, 1.5),
        bend(0.6, -0.8, Vec3::Y, 1.5),
        bend(0.28, 0.96, Vec3::Y, 1.5),
        bend(0.8, 0.6, Vec3::Y, 1.5),
    ];
    for trial in 0..200 {
        let mut stream = Stream::of_trial(741, trial);
        let [incoming, outward] = [(); 2].map(|()| direction(&mut stream));
        bends.push(Bend { incoming, outward, index: stream.between(1.1, 2.5) });
    }
    bends.retain(|it| (it.sine() - 1.0).abs() > 1e-3 && it.incoming.dot(it.outward).abs() > 1e-3);
    bends
}

fn direction(stream: &mut Stream) -> Vec3 {
    let mut component = || stream.between(-1.0, 1.0);
    let vector = Vec3::new(component(), component(), component());
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
}

impl Bend {
    /// The factor by which what runs across the normal grows.
    fn ratio(&self) -> f64 {
        let entering = self.incoming.dot(self.outward) < 0.0;
        if entering { 1.0 / f64::from(self.index) } else { f64::from(self.index) }
    }

    fn sine(&self) -> f64 {
        self.ratio() * self.incoming.as_dvec3().cross(self.outward.as_dvec3()).length()
    }

    /// What runs across the normal is scaled by the ratio; what is missing of length 1 runs along
    /// the normal, the same way as before.
    pub(super) fn direction(&self) -> Option<Vec3> {
        let (incoming, outward) = (self.incoming.as_dvec3(), self.outward.as_dvec3());
        let along = incoming.dot(outward);
        let across = self.ratio() * (incoming - along * outward);
        let rest = 1.0 - across.length_squared();
        (rest > 0.0).then(|| (across + rest.sqrt().copysign(along) * outward).as_vec3())
    }
}

/// Two rays, of which one is to be looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    part: f32,
    mirrored: f32,
    refracted: f32,
}

pub(super) fn pairs() -> Vec<Pair> {
    let pair = |part, mirrored, refracted| Pair { part, mirrored, refracted };
    vec![
        pair(0.25, 1.0, 0.5),
        pair(0.04, 3.0, 0.4),
        pair(0.9, 0.2, 7.0),
        pair(0.5, 2.0, 1.0),
        pair(0.7, 0.0, 1.5),
    ]
}

impl Pair {
    pub(super) fn exact(&self) -> Estimate {
        let [part, mirrored, refracted] = [self.part, self.mirrored, self.refracted].map(f64::from);
        Estimate::exact(part * mirrored + (1.0 - part) * refracted)
    }

    /// The mean of ten thousand answers.
    pub(super) fn estimate(&self, answer: fn(f32, f32, f32, f32) -> f32) -> Estimate {
        let chance = |trial| Stream::of_trial(742, trial).uniform();
        let of = |trial| answer(self.part, self.mirrored, self.refracted, chance(trial));
        let samples: Running = (0..10_000).map(|trial| f64::from(of(trial))).collect();
        Estimate::of(&samples).expect("many samples")
    }
}

/// An interface, and what comes from both sides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub(super) surface: Surface,
    pub(super) mirrored: Color,
    pub(super) refracted: Color,
}

pub(super) fn seens() -> Vec<Seen> {
    let mut stream = Stream::of_trial(743, 0);
    let mut color =
        || Color::new(stream.between(0.1, 2.0), stream.between(0.1, 2.0), stream.between(0.1, 2.0));
    let seen = |surface| Seen { surface, mirrored: color(), refracted: color() };
    surfaces().into_iter().map(seen).collect()
}

impl Seen {
    /// Radiance over the index squared is what passes.
    pub(super) fn radiance(&self) -> Color {
        let Self { surface, mirrored, refracted } = *self;
        let square = |index: f32| f64::from(index) * f64::from(index);
        let reflected = f64::from(surface.reflectance());
        let basic = mirrored.as_dvec3() * reflected / square(surface.near)
            + refracted.as_dvec3() * (1.0 - reflected) / square(surface.far);
        (basic * square(surface.near)).as_vec3()
    }
}
