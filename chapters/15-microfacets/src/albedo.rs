//! How much light a rough surface sends back, and how much it loses.

use std::f64::consts::{LN_2, PI};

use glam::{DVec2, DVec3};

use crate::facets::Masking;

// ANCHOR: albedo
/// The part of the light from a uniform sky that facets send to a direction whose cosine is `cosine`,
/// above 0, when each of them reflects all: 1 if no light is lost.
///
/// The integral of D G₂ / (4 z z') times z' over all incoming directions, in `f64`: the mean of
/// G₂ / G₁ over `steps`² normals, each with the same share of those that are seen.
pub fn albedo(alpha: f64, cosine: f64, masking: Masking, steps: u32) -> f64 {
    let outgoing = DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
    let middle = |step: u32| (f64::from(step) + 0.5) / f64::from(steps);
    let cells = (0..steps).flat_map(|i| (0..steps).map(move |j| (middle(i), middle(j))));
    let sum: f64 = cells.map(|(u, v)| part(alpha, outgoing, DVec2::new(u, v), masking)).sum();
    sum / (f64::from(steps) * f64::from(steps))
}

/// G₂ / G₁ for one normal; 0 where its facet reflects light down into the surface.
fn part(alpha: f64, outgoing: DVec3, u: DVec2, masking: Masking) -> f64 {
    let scale = DVec3::new(alpha, alpha, 1.0);
    let view = (outgoing * scale).normalize();
    let z = 1.0 - u.x * (1.0 + view.z);
    let (sine, turn) = libm::sincos(PI * u.y);
    let radius = (1.0 - z * z).max(0.0).sqrt();
    let normal = ((DVec3::new(radius * turn, radius * sine, z) + view) * scale).normalize();
    let incoming = 2.0 * outgoing.dot(normal) * normal - outgoing;
    if !(incoming.z > 0.0) {
        return 0.0;
    }
    let lambda = |direction: DVec3| {
        let slope = (1.0 / (direction.z * direction.z) - 1.0).max(0.0);
        ((1.0 + alpha * alpha * slope).sqrt() - 1.0) / 2.0
    };
    let (seen, lit) = (lambda(outgoing), lambda(incoming));
    match masking {
        Masking::Correlated => (1.0 + seen) / (1.0 + seen + lit),
        Masking::Separable => 1.0 / (1.0 + lit),
    }
}
// ANCHOR_END: albedo

// ANCHOR: closed
/// The same for a roughness of 1, where D is 1/π and a direction's stretch is 1, so that it is the
/// integral of z / (z + `cosine`) over z from 0 to 1: 1 - cosine ln(1 + 1 / cosine).
///
/// With [`Masking::Separable`] it is that of 2 z / ((1 + z) (1 + `cosine`)).
pub fn roughest(cosine: f64, masking: Masking) -> f64 {
    match masking {
        Masking::Correlated => 1.0 - cosine * libm::log1p(1.0 / cosine),
        Masking::Separable => 2.0 * (1.0 - LN_2) / (1.0 + cosine),
    }
}
// ANCHOR_END: closed

#[cfg(test)]
mod tests {
    use super::{albedo, roughest};
    use crate::facets::Masking::{Correlated, Separable};

    #[test]
    fn by_hand() {
        // 1 - ln 2.
        assert!((roughest(1.0, Correlated) - 0.306_852_819).abs() < 1e-9);
        assert!((albedo(1.0, 1.0, Correlated, 400) - 0.306_852_819).abs() < 1e-5);
    }

    #[test]
    fn the_sum_is_the_closed_form_at_roughness_1() {
        for masking in [Correlated, Separable] {
            for cosine in [1.0, 0.8, 0.5, 0.2, 0.05] {
                let (sum, closed) = (albedo(1.0, cosine, masking, 400), roughest(cosine, masking));
                assert!((sum - closed).abs() < 1e-4, "{masking:?} {cosine}: {sum} {closed}");
            }
        }
    }

    #[test]
    fn a_mirror_loses_nothing_and_nothing_makes_light() {
        for cosine in [1.0, 0.5, 0.1] {
            assert!((albedo(1e-4, cosine, Correlated, 200) - 1.0).abs() < 1e-3);
            for alpha in [0.05, 0.2, 0.5, 0.8] {
                let [more, less] = [Correlated, Separable].map(|it| albedo(alpha, cosine, it, 200));
                assert!(less <= more && more <= 1.0 + 1e-6, "{alpha} {cosine}: {less} {more}");
            }
        }
    }
}
