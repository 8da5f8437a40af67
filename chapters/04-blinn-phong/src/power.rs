//! The power of a cosine, with the same bits on every machine.

use std::f64::consts::{FRAC_1_SQRT_2, LN_2};

// ANCHOR: power
/// `cosine` to the power `exponent`, for a cosine above 0 and at most 1 and an exponent from 0 up:
/// 2 to the power n log₂ c.
///
/// In `f64`, of which `f32` needs less than half the digits. So the two series may end early, and the
/// result is still the nearest `f32` but for one time in a million or so. `+ - * /` are the same on
/// every machine, and there is nothing else in it.
#[inline]
pub fn power_of_cosine(cosine: f32, exponent: f32) -> f32 {
    exp2(f64::from(exponent) * log2(f64::from(cosine))) as f32
}

/// The logarithm to base 2 of a number with an exponent of its own, as every `f32` above 0 is in
/// `f64`.
#[inline]
fn log2(value: f64) -> f64 {
    // value = 2^k m, with m from √½ to √2.
    let k = (value.to_bits() as i64 - FRAC_1_SQRT_2.to_bits() as i64) >> 52;
    let m = f64::from_bits((value.to_bits() as i64 - (k << 52)) as u64);
    // ln m = 2 (s + s³/3 + s⁵/5 + ...), which ends quickly: s is below 0.172.
    let s = (m - 1.0) / (m + 1.0);
    let series = polynomial(s * s, &ODD);
    k as f64 + 2.0 / LN_2 * s * series
}

/// 2 to a power that is not above 0.
#[inline]
pub(crate) fn exp2(power: f64) -> f64 {
    // 2^k times 2^f, with f from -½ to ½.
    let power = power.max(-1000.0);
    let k = (power - 0.5) as i64;
    let f = power - k as f64;
    f64::from_bits(((1023 + k) as u64) << 52) * polynomial(LN_2 * f, &FACTORIALS)
}
// ANCHOR_END: power

/// The factors of s, s³, s⁵ and so on in the logarithm, divided by s: 1, 1/3, 1/5 ...
const ODD: [f64; 8] = {
    let mut odd = [1.0; 8];
    let mut index = 1;
    while index < odd.len() {
        odd[index] = 1.0 / (2 * index + 1) as f64;
        index += 1;
    }
    odd
};

/// The factors of the exponential: 1, 1, 1/2, 1/6 ...
const FACTORIALS: [f64; 12] = {
    let mut factors = [1.0; 12];
    let mut index = 1;
    while index < factors.len() {
        factors[index] = factors[index - 1] / index as f64;
        index += 1;
    }
    factors
};

/// The sum of the factors times 1, x, x² and so on.
#[inline]
fn polynomial<const N: usize>(x: f64, factors: &[f64; N]) -> f64 {
    factors.iter().rev().fold(0.0, |sum, factor| sum * x + factor)
}

#[cfg(test)]
mod tests {
    use common::math;
    use common::sampler::Stream;

    use super::{exp2, log2, power_of_cosine};
    use crate::squaring;

    #[test]
    fn logarithms_and_powers_of_two_are_exact() {
        for k in 0..1000 {
            let power = squaring::power(1.0, 0.5, k);
            assert_eq!((log2(power), exp2(-f64::from(k))), (-f64::from(k), power));
        }
        assert_eq!(exp2(f64::NEG_INFINITY) as f32, 0.0);
    }

    #[test]
    fn whole_powers_are_the_nearest_numbers() {
        let mut further = 0;
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(44, trial);
            let cosine = stream.uniform().max(1e-6);
            let exponent = 1 + stream.bits() % 200;
            let exact = squaring::power(1.0, f64::from(cosine), exponent);
            further += u32::from(power_of_cosine(cosine, exponent as f32) != exact as f32);
        }
        assert!(further <= 1, "{further} of 200,000");
    }

    /// Another road to the same place: a power function that shares nothing with this one.
    #[test]
    fn any_power_is_what_libm_says_to_a_unit_or_two() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(45, trial);
            let cosine = 1.0 - math::pow(10.0, stream.between(-7.0, 0.0));
            let exponent = math::pow(10.0, stream.between(-3.0, 6.0));
            if cosine > 0.0 {
                let [ours, theirs] = [power_of_cosine, math::pow].map(|it| it(cosine, exponent));
                let apart = ours.to_bits().abs_diff(theirs.to_bits());
                assert!(apart <= 1, "{cosine}^{exponent}: {ours} {theirs}");
            }
        }
    }

    #[test]
    fn the_ends() {
        for exponent in [0.0, 1e-30, 1.0, 1e6, f32::MAX] {
            assert_eq!(power_of_cosine(1.0, exponent), 1.0);
        }
        let (smallest, below_one) = (f32::from_bits(1), 1.0 - f32::EPSILON / 2.0);
        assert_eq!(power_of_cosine(smallest, 1.0), smallest);
        assert_eq!(power_of_cosine(smallest, 0.0), 1.0);
        assert_eq!(power_of_cosine(smallest, 2.0), 0.0);
        assert_eq!(power_of_cosine(below_one, f32::MAX), 0.0);
    }
}
