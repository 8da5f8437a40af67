//! How much glass reflects: Fresnel's equations for media that absorb nothing.

use crate::interface::Interface;

// ANCHOR: reflectance
/// The part of unpolarized light that an interface reflects, for the cosine of the angle on this
/// side, from 0 to 1. The rest goes through.
///
/// Fresnel, "Mémoire sur la loi des modifications que la réflexion imprime à la lumière polarisée"
/// (1823), with cosines in place of its sines and tangents.
pub fn reflectance(interface: &Interface, cosine: f64) -> f64 {
    let far_cosine = interface.far_cosine(cosine);
    far_cosine.map_or(1.0, |far_cosine| between(interface, cosine, far_cosine))
}

/// The same where both cosines are known.
pub fn between(interface: &Interface, cosine: f64, far_cosine: f64) -> f64 {
    // At a cosine of 0 the equations would divide nothing by nothing.
    if interface.is_none() {
        return 0.0;
    }
    let ratio = interface.ratio();
    let perpendicular = (ratio * cosine - far_cosine) / (ratio * cosine + far_cosine);
    let parallel = (cosine - ratio * far_cosine) / (cosine + ratio * far_cosine);
    (perpendicular * perpendicular + parallel * parallel) / 2.0
}
// ANCHOR_END: reflectance

#[cfg(test)]
mod tests {
    use common::sampler::Stream;

    use super::reflectance;
    use crate::index::Index;
    use crate::interface::Interface;

    fn interface(near: f32, far: f32) -> Interface {
        let index = |number| Index::new(number).expect("an index");
        Interface::new(index(near), index(far))
    }

    #[test]
    fn by_hand() {
        // Straight into glass: (0.5 / 2.5)² = 0.04; at a sine of 0.6, cosines 0.8 and 0.916515:
        // perpendicular (0.8 - 1.374773) / 2.174773, parallel (1.2 - 0.916515) / 2.116515.
        let glass = interface(1.0, 1.5);
        assert!((reflectance(&glass, 1.0) - 0.04).abs() < 1e-15);
        let perpendicular = -0.574_773_0_f64 / 2.174_773_0;
        let parallel = 0.283_484_9_f64 / 2.116_515_1;
        let expected = (perpendicular * perpendicular + parallel * parallel) / 2.0;
        assert!((reflectance(&glass, 0.8) - expected).abs() < 1e-7);
    }

    #[test]
    fn at_brewster_s_angle_only_one_polarization_is_reflected() {
        // tan of the angle is the ratio of indices, cosine 1 / sqrt(1 + n²); there the
        // perpendicular amplitude is (1 - n²) / (1 + n²).
        for n in [1.33, 1.5, 2.42_f32] {
            let square = f64::from(n) * f64::from(n);
            let amplitude = (1.0 - square) / (1.0 + square);
            let found = reflectance(&interface(1.0, n), (1.0 + square).sqrt().recip());
            assert!((found - amplitude * amplitude / 2.0).abs() < 1e-15, "{n}");
        }
    }

    #[test]
    fn grazing_light_is_reflected_and_total_is_total() {
        for (near, far) in [(1.0, 1.5), (1.5, 1.0), (1.0, 1.000_001), (0.001, 3.0)] {
            assert_eq!(reflectance(&interface(near, far), 0.0), 1.0, "{near} {far}");
        }
        assert_eq!(reflectance(&interface(1.5, 1.0), 0.7), 1.0);
        assert!(reflectance(&interface(1.5, 1.0), 0.75) < 0.7);
    }

    #[test]
    fn nothing_is_reflected_where_nothing_changes() {
        for cosine in [0.0, 1e-30, 1e-3, 0.5, 1.0] {
            assert_eq!(reflectance(&interface(1.7, 1.7), cosine), 0.0);
        }
    }

    #[test]
    fn the_same_from_both_sides_and_never_more_than_all() {
        for trial in 0..500_000 {
            let mut stream = Stream::of_trial(706, trial);
            let glass = interface(stream.between(0.2, 3.0), stream.between(0.2, 3.0));
            let cosine = f64::from(stream.uniform());
            let here = reflectance(&glass, cosine);
            assert!((0.0..=1.0).contains(&here));
            let Some(beyond) = glass.far_cosine(cosine) else { continue };
            let there = reflectance(&glass.reversed(), beyond);
            assert!((here - there).abs() < 1e-7, "{glass:?} {cosine}: {here} {there}");
        }
    }
}
