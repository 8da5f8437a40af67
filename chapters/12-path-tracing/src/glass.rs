//! Clear glass in air.

use common::film::Color;
use fresnel::dielectric;
use fresnel::index::Index;
use fresnel::interface::Interface;
use glam::{DVec3, Vec3};

use crate::bsdf::{Bsdf, BsdfSample};
use crate::mirror::mirrored;
use crate::random::{LOBE, Random};

// ANCHOR: glass
/// The surface of a body of glass: outside is air.
///
/// What a path carries is radiance divided by the square of the index around it, as in chapter 7, so
/// refraction changes nothing of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    /// The glass's index of refraction.
    pub index: Index,
}

impl Bsdf for Glass {
    #[inline]
    fn eval(&self, _outgoing: Vec3, _incoming: Vec3) -> Color {
        Color::ZERO
    }

    #[inline]
    fn pdf(&self, _outgoing: Vec3, _incoming: Vec3) -> f32 {
        0.0
    }

    /// One of the two ways, each as often as it has light: so it counts in full.
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        let interface = self.interface(outgoing);
        let cosine = f64::from(outgoing.z.abs()).min(1.0);
        let far_cosine = interface.far_cosine(cosine);
        let reflected = far_cosine.map_or(1.0, |far| dielectric::between(&interface, cosine, far));
        let chosen = far_cosine.filter(|_| f64::from(random.number(LOBE)) >= reflected);
        let (incoming, probability) = match chosen {
            None => (mirrored(outgoing), reflected),
            Some(far) => (refracted(outgoing, &interface, far)?, 1.0 - reflected),
        };
        let pdf = probability as f32;
        Some(BsdfSample { incoming, weight: Color::ONE, pdf, is_delta: true })
    }

    #[inline]
    fn spreads(&self) -> bool {
        false
    }
}
// ANCHOR_END: glass

impl Glass {
    /// The interface as a ray finds it that comes from the side of `outgoing`.
    fn interface(&self, outgoing: Vec3) -> Interface {
        let entering = Interface::new(Index::AIR, self.index);
        if outgoing.z > 0.0 { entering } else { entering.reversed() }
    }
}

/// The direction beyond: Snell's law for what runs along the surface.
fn refracted(outgoing: Vec3, interface: &Interface, far_cosine: f64) -> Option<Vec3> {
    let along = -interface.ratio() * outgoing.as_dvec3().truncate();
    let z = far_cosine.copysign(-f64::from(outgoing.z));
    DVec3::new(along.x, along.y, z).try_normalize().map(|direction| direction.as_vec3())
}

#[cfg(test)]
mod tests {
    use fresnel::index::Index;
    use glam::Vec3;

    use super::Glass;
    use crate::bsdf::{Bsdf, BsdfSample};
    use crate::random::Random;

    const GLASS: Glass = Glass { index: Index::GLASS };

    fn samples(outgoing: Vec3) -> impl Iterator<Item = BsdfSample> {
        let sample = move |trial| GLASS.sample(outgoing, &Random::of_trial(127, trial));
        (0..10_000).map(move |trial| sample(trial).expect("all light goes somewhere"))
    }

    #[test]
    fn straight_on_one_ray_of_25_is_reflected() {
        // F = (0.5 / 2.5)² = 0.04; of 10,000 draws the count has a standard deviation of 20.
        let reflected = samples(Vec3::Z).filter(|sample| sample.incoming.z > 0.0);
        let reflected: Vec<BsdfSample> = reflected.collect();
        assert!((reflected.len() as f64 - 400.0).abs() < 100.0, "{}", reflected.len());
        assert!((reflected[0].pdf - 0.04).abs() < 1e-7);
    }

    #[test]
    fn by_hand_as_in_chapter_7() {
        // A sine of 0.6 outside becomes 0.4 inside.
        for sample in samples(Vec3::new(-0.6, 0.0, 0.8)).take(200) {
            let right = if sample.incoming.z > 0.0 {
                Vec3::new(0.6, 0.0, 0.8)
            } else {
                Vec3::new(0.4, 0.0, -0.916_515_1)
            };
            assert!((sample.incoming - right).length() < 1e-6, "{sample:?}");
            assert!(sample.is_delta && sample.weight == common::film::Color::ONE);
        }
    }

    #[test]
    fn beyond_the_critical_angle_nothing_leaves() {
        // Inside, a sine of 0.8 would become 1.2.
        for sample in samples(Vec3::new(0.8, 0.0, -0.6)).take(200) {
            assert_eq!(sample.incoming, Vec3::new(-0.8, 0.0, -0.6));
            assert_eq!(sample.pdf, 1.0);
        }
    }

    #[test]
    fn out_is_as_likely_as_in() {
        let probability = |outgoing: Vec3| {
            samples(outgoing).find(|it| it.incoming.z * outgoing.z > 0.0).expect("some").pdf
        };
        let outside = probability(Vec3::new(-0.6, 0.0, 0.8));
        let inside = probability(Vec3::new(0.4, 0.0, -0.916_515_1));
        assert!((outside - inside).abs() < 1e-6, "{outside}, {inside}");
    }
}
