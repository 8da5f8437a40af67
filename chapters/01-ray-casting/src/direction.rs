//! Directions: vectors of length 1, from vectors of any length.

use common::math::difference_of_products;
use glam::Vec3;

// ANCHOR: unit
/// `vector` scaled to length 1, to within 2 ε; None when it is zero or not finite.
///
/// The squares in a length overflow above 1.8e19 and vanish below 1e-23, though the vector itself
/// is a perfectly good one (hard case X-02). So it is first scaled by the power of two that brings
/// its largest component near 1. Such a product is exact, but for components too small to matter.
pub fn unit(vector: Vec3) -> Option<Vec3> {
    let largest = vector.abs().max_element();
    if !(largest > 0.0 && vector.is_finite()) {
        return None;
    }
    let near_one = vector * power_of_two_near_inverse(largest);
    Some(near_one / near_one.length())
}
// ANCHOR_END: unit

/// The power of two that brings a positive finite `value` into [1, 4), or from below 2^-126 to at
/// least 2^-23: the exponent's bits, mirrored.
fn power_of_two_near_inverse(value: f32) -> f32 {
    let exponent = (value.to_bits() >> 23).clamp(1, 253);
    f32::from_bits((254 - exponent) << 23)
}

/// The cross product with each component right to 1.5 units in its last place.
///
/// `Vec3::cross` loses all its digits when the vectors are nearly parallel, and with them the right
/// angle to both (hard case X-07).
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(
        difference_of_products(a.y, b.z, a.z, b.y),
        difference_of_products(a.z, b.x, a.x, b.z),
        difference_of_products(a.x, b.y, a.y, b.x),
    )
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;

    use super::{cross, unit};

    /// A vector whose components have any bits but those of NaN and infinity.
    fn any(stream: &mut Stream) -> Vec3 {
        let mut component = || f32::from_bits(stream.bits());
        let vector = Vec3::new(component(), component(), component());
        if vector.is_finite() { vector } else { any(stream) }
    }

    fn length_error(direction: Vec3) -> f64 {
        (direction.as_dvec3().length() - 1.0).abs()
    }

    #[test]
    fn every_vector_of_f32_gets_length_1() {
        let bound = 2.0 * f64::from(f32::EPSILON);
        for trial in 0..1_000_000 {
            let vector = any(&mut Stream::of_trial(12, trial));
            let direction = unit(vector).expect("not zero");
            assert!(length_error(direction) <= bound, "{vector:?}");
        }
    }

    #[test]
    fn the_smallest_and_the_largest_vectors_there_are() {
        let smallest = f32::from_bits(1);
        let bound = 2.0 * f64::from(f32::EPSILON);
        for vector in [
            Vec3::new(smallest, 0.0, 0.0),
            Vec3::new(smallest, 2.0 * smallest, -smallest),
            Vec3::new(f32::MIN_POSITIVE, -smallest, f32::MIN_POSITIVE),
            Vec3::new(f32::MAX, -f32::MAX, f32::MAX),
            Vec3::new(0.0, f32::MAX, smallest),
        ] {
            let direction = unit(vector).expect("finite and not zero");
            assert!(length_error(direction) <= bound, "{vector:?} gave {direction:?}");
            assert!((0..3).all(|axis| direction[axis] * vector[axis] >= 0.0), "signs stay");
        }
        assert_eq!(Vec3::splat(1e20).normalize(), Vec3::ZERO, "the naive form");
    }

    #[test]
    fn no_direction_without_length_or_end() {
        for vector in
            [Vec3::ZERO, Vec3::NAN, Vec3::X * f32::INFINITY, Vec3::new(1.0, f32::NAN, 2.0)]
        {
            assert_eq!(unit(vector), None, "{vector:?}");
        }
    }

    #[test]
    fn a_power_of_two_changes_no_bit() {
        for (trial, exponent) in (0..2000).zip((-60..60).cycle()) {
            let mut stream = Stream::of_trial(13, trial);
            let mut component = || stream.between(-3.0, 5.0);
            let vector = Vec3::new(component(), component(), component());
            let scale = f32::from_bits(((127 + exponent) as u32) << 23);
            assert_eq!(unit(vector * scale), unit(vector));
        }
    }

    #[test]
    fn the_cross_product_of_nearly_parallel_vectors() {
        let a = Vec3::new(0.1, 0.2, 0.3);
        let b = Vec3::new(0.1, 0.2, 0.3 + 2.0 * f32::EPSILON);
        let exact = a.as_dvec3().cross(b.as_dvec3());
        let error = |vector: Vec3| (vector.as_dvec3() - exact).length() / exact.length();
        assert!(error(cross(a, b)) < 2e-7, "{}", error(cross(a, b)));
        assert!(error(a.cross(b)) > 1e-3, "{}", error(a.cross(b)));
    }
}
