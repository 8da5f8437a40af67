//! A slab of glass: light that goes to and fro inside, and how much comes out in all.

use glam::{DVec3, Vec3};

use crate::bend::Incidence;
use crate::dielectric::between;
use crate::interface::Interface;

/// What a slab does to light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// The part that comes back.
    pub reflected: f64,
    /// The part that goes through.
    pub transmitted: f64,
}

// ANCHOR: closed
/// The closed form: each pass between the faces reflects F, so that transmitted light is
/// (1 - F)² (1 + F² + F⁴ + ...) = (1 - F) / (1 + F).
pub fn closed(reflectance: f64) -> Balance {
    Balance {
        reflected: 2.0 * reflectance / (1.0 + reflectance),
        transmitted: (1.0 - reflectance) / (1.0 + reflectance),
    }
}
// ANCHOR_END: closed

// ANCHOR: summed
/// The same added up reflection by reflection, each at the cosine that the refracted direction
/// really has, until less than `rest` is left inside. Radiance is followed, so each crossing scales
/// it by the square of the indices' ratio.
pub fn summed(into: &Interface, direction: DVec3, normal: Vec3, rest: f64) -> Balance {
    let out = into.reversed();
    let incidence = Incidence::new(direction, normal);
    let Some(inside) = into.far_cosine(incidence.cosine) else {
        return Balance { reflected: 1.0, transmitted: 0.0 };
    };
    let first = between(into, incidence.cosine, inside);
    let mut balance = Balance { reflected: first, transmitted: 0.0 };
    let mut left = (1.0 - first) / (into.ratio() * into.ratio());
    let mut travelling = incidence.refracted(into, inside);
    let mut at_the_back = true;
    while left > rest {
        let incidence = Incidence::new(travelling, normal);
        let outside = out.far_cosine(incidence.cosine);
        let kept = outside.map_or(1.0, |outside| between(&out, incidence.cosine, outside));
        let leaves = left * (1.0 - kept) / (out.ratio() * out.ratio());
        let side = if at_the_back { &mut balance.transmitted } else { &mut balance.reflected };
        *side += leaves;
        if kept >= 1.0 {
            // Trapped: it would go to and fro for ever.
            return balance;
        }
        left *= kept;
        travelling = incidence.reflected();
        at_the_back = !at_the_back;
    }
    balance
}
// ANCHOR_END: summed

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::{DVec3, Vec3};

    use super::{closed, summed};
    use crate::dielectric::reflectance;
    use crate::index::Index;
    use crate::interface::Interface;

    #[test]
    fn by_hand() {
        // F = 0.04 straight into glass: 0.96 / 1.04 goes through.
        let glass = Interface::new(Index::AIR, Index::GLASS);
        let balance = summed(&glass, DVec3::NEG_Z, Vec3::Z, 1e-18);
        assert!((balance.transmitted - 0.923_076_923_076_923).abs() < 1e-14, "{balance:?}");
        assert!((balance.reflected - 0.076_923_076_923_077).abs() < 1e-14);
        assert_eq!(closed(0.04).transmitted, 0.96 / 1.04);
    }

    #[test]
    fn every_angle_keeps_all_energy_and_agrees_with_the_closed_form() {
        for trial in 0..20_000 {
            let mut stream = Stream::of_trial(710, trial);
            let far = Index::new(stream.between(1.05, 3.0)).expect("an index");
            let glass = Interface::new(Index::AIR, far);
            let cosine = f64::from(stream.between(0.02, 1.0));
            let direction = DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, -cosine);
            let balance = summed(&glass, direction, Vec3::Z, 1e-16);
            let closed = closed(reflectance(&glass, cosine));
            assert!((balance.reflected + balance.transmitted - 1.0).abs() < 1e-12);
            assert!((balance.transmitted - closed.transmitted).abs() < 1e-12, "{far:?} {cosine}");
        }
    }
}
