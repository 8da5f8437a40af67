//! Which way light goes on from an interface: the mirror's way, and through.
//!
//! Directions here have twice the digits of a ray's. A ray that grazes glass on its way in is, inside,
//! at the critical angle to the last few digits; an `f32` direction has lost the angle at which it
//! must leave, and no formula gets it back (hard case WH-05).

use glam::{DVec3, Vec3};
use ray_casting::shape::Hit;

use crate::interface::Interface;

// ANCHOR: incidence
/// How a ray comes upon a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incidence {
    /// The ray's direction, of length 1.
    pub direction: DVec3,
    /// The surface's normal, of length 1, on the side the ray comes from.
    pub normal: DVec3,
    /// The cosine of the angle between the normal and the way back, from 0 to 1.
    pub cosine: f64,
}

impl Incidence {
    /// A ray along `direction` that meets a surface with `normal`, of whichever side.
    pub fn new(direction: DVec3, normal: Vec3) -> Self {
        // Scaled to length 1 again, for an f32 normal has it to seven digits only.
        let normal = normal.as_dvec3().normalize();
        let along = direction.dot(normal);
        let normal = if along > 0.0 { -normal } else { normal };
        Self { direction, normal, cosine: along.abs().min(1.0) }
    }
    // ANCHOR_END: incidence

    // ANCHOR: reflect
    /// The mirror's direction.
    pub fn reflected(&self) -> DVec3 {
        self.direction + 2.0 * self.cosine * self.normal
    }
    // ANCHOR_END: reflect

    // ANCHOR: refract
    /// The direction beyond the interface, where the cosine is `far_cosine`.
    ///
    /// Snell's law for vectors: what the direction has across the normal is scaled by
    /// `ratio`, and what it has along the normal becomes `far_cosine`.
    pub fn refracted(&self, interface: &Interface, far_cosine: f64) -> DVec3 {
        let ratio = interface.ratio();
        ratio * self.direction + (ratio * self.cosine - far_cosine) * self.normal
    }
    // ANCHOR_END: refract

    /// Both directions, and the cosine beyond.
    fn bent(self, interface: &Interface, side: DVec3) -> Bent {
        let refracted = interface
            .far_cosine(self.cosine)
            .map(|cosine| Refracted { cosine, direction: self.refracted(interface, cosine) });
        Bent { incidence: self, reflected: self.reflected(), refracted, side }
    }
}

/// Where light goes on from an interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bent {
    /// How the ray came upon it.
    pub incidence: Incidence,
    /// The mirror's direction.
    pub reflected: DVec3,
    /// The way through; None for total reflection.
    pub refracted: Option<Refracted>,
    /// The surface's own normal, on the side the ray comes from.
    pub side: DVec3,
}

/// The way through an interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refracted {
    /// The cosine beyond.
    pub cosine: f64,
    /// The direction, of length 1.
    pub direction: DVec3,
}

// ANCHOR: bent
/// Where light goes on from `hit`: by the normal it is to be shaded with, or by the surface's own
/// where that one would send a ray to the wrong side.
#[inline]
pub fn bent(direction: DVec3, hit: &Hit, interface: &Interface) -> Bent {
    let flat = Incidence::new(direction, hit.geometric);
    if hit.normal != hit.geometric {
        let smooth = Incidence::new(direction, hit.normal);
        let bent = smooth.bent(interface, flat.normal);
        let rises = bent.reflected.dot(flat.normal) > 0.0;
        let sinks = bent.refracted.is_none_or(|it| it.direction.dot(flat.normal) < 0.0);
        if rises && sinks && smooth.normal.dot(flat.normal) > 0.0 {
            return bent;
        }
    }
    flat.bent(interface, flat.normal)
}
// ANCHOR_END: bent

/// The direction of length 1, to `f64`, along a ray's own, which has length 1 to `f32`.
pub fn precise(direction: Vec3) -> DVec3 {
    direction.as_dvec3().normalize()
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::{DVec3, Vec2, Vec3};
    use ray_casting::shape::Hit;

    use super::{Incidence, bent, precise};
    use crate::index::Index;
    use crate::interface::Interface;

    fn vector(stream: &mut Stream) -> Vec3 {
        let mut component = || stream.between(-1.0, 1.0);
        let vector = Vec3::new(component(), component(), component());
        if vector.length() > 0.1 { vector } else { self::vector(stream) }
    }

    #[test]
    fn by_hand() {
        // Into index 1.5 at a sine of 0.6: the sine beyond is 0.4, the cosine the root of 0.84.
        let incidence = Incidence::new(DVec3::new(0.6, -0.8, 0.0), Vec3::Y);
        assert!((incidence.reflected() - DVec3::new(0.6, 0.8, 0.0)).length() < 1e-15);
        let glass = Interface::new(Index::AIR, Index::GLASS);
        let beyond = glass.far_cosine(incidence.cosine).expect("it enters");
        let expected = DVec3::new(0.4, -0.84_f64.sqrt(), 0.0);
        assert!((incidence.refracted(&glass, beyond) - expected).length() < 1e-15);
        let turned = Incidence::new(DVec3::new(0.6, -0.8, 0.0), Vec3::NEG_Y);
        assert_eq!(turned, incidence, "whichever side the normal is on");
    }

    #[test]
    fn lengths_angles_and_the_plane_of_incidence() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(703, trial);
            let direction = precise(vector(&mut stream));
            let incidence = Incidence::new(direction, vector(&mut stream));
            let near = Index::new(stream.between(0.5, 3.0)).expect("an index");
            let interface = Interface::new(near, Index::GLASS);
            let reflected = incidence.reflected();
            assert!((reflected.length() - 1.0).abs() < 1e-14);
            assert!((reflected.dot(incidence.normal) - incidence.cosine).abs() < 1e-14);
            let Some(cosine) = interface.far_cosine(incidence.cosine) else { continue };
            let refracted = incidence.refracted(&interface, cosine);
            // Clamped squares make for lengths that are right to the root of the rounding.
            let near_critical = cosine < 1e-5;
            assert!(near_critical || (refracted.length() - 1.0).abs() < 1e-10);
            let plane = incidence.direction.cross(incidence.normal);
            assert!(refracted.dot(plane).abs() < 1e-14 && reflected.dot(plane).abs() < 1e-14);
        }
    }

    /// Paths are reversible: what came in along a goes out along b, and what comes in along -b goes
    /// out along -a.
    #[test]
    fn a_refracted_ray_turned_round_comes_back() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(704, trial);
            let incidence = Incidence::new(precise(vector(&mut stream)), vector(&mut stream));
            let far = Index::new(stream.between(1.0, 3.0)).expect("an index");
            let interface = Interface::new(Index::AIR, far);
            let cosine = interface.far_cosine(incidence.cosine).expect("into the denser medium");
            let there = incidence.refracted(&interface, cosine);
            let back = Incidence { direction: -there, normal: -incidence.normal, cosine };
            let home = interface.reversed().far_cosine(back.cosine).expect("it came from there");
            let returned = back.refracted(&interface.reversed(), home);
            let error = (returned + incidence.direction).length();
            // The cosine's own error is u / cosine.
            assert!(error < 4e-15 / incidence.cosine, "{error:e} at {}", incidence.cosine);
        }
    }

    #[test]
    fn a_leaning_normal_sends_no_ray_to_the_wrong_side() {
        let (mut leaning, mut flat) = (0, 0);
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(719, trial);
            let geometric = vector(&mut stream).normalize();
            let normal = (geometric + 0.5 * vector(&mut stream)).normalize();
            let (point, uv) = (Vec3::ZERO, Vec2::ZERO);
            let hit = Hit { t: 1.0, point, error: Vec3::ZERO, geometric, normal, uv };
            let interface = Interface::new(Index::AIR, Index::GLASS);
            let direction = precise(vector(&mut stream));
            let way = bent(direction, &hit, &interface);
            assert!(way.reflected.dot(way.side) > 0.0, "{hit:?}");
            let refracted = way.refracted.expect("into glass");
            assert!(refracted.direction.dot(way.side) < 0.0, "{hit:?}");
            assert!(way.side.dot(direction) <= 0.0);
            let smooth = way.incidence == Incidence::new(direction, normal);
            (leaning, flat) = (leaning + u32::from(smooth), flat + u32::from(!smooth));
        }
        assert!(leaning > 100_000 && flat > 1000, "the control: {leaning} {flat}");
    }

    #[test]
    fn equal_indices_change_no_bit_of_a_direction() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(705, trial);
            let incidence = Incidence::new(precise(vector(&mut stream)), vector(&mut stream));
            let medium = Index::new(stream.between(0.1, 4.0)).expect("an index");
            let none = Interface::new(medium, medium);
            let cosine = none.far_cosine(incidence.cosine).expect("nothing is in its way");
            assert_eq!(incidence.refracted(&none, cosine), incidence.direction);
        }
    }
}
