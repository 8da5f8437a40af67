//! From linear light to the numbers a display takes, and back (IEC 61966-2-1, sRGB).

use crate::math;

/// Where the straight piece and the power of the curve meet, in linear light.
///
/// The standard prints 0.0031308, rounded to five digits. There the power lies 2.9e-8 below the
/// straight piece: seven floats, so the curve would step down. This is the crossing to 17 digits.
const KNEE: f64 = 0.003_130_668_442_500_64;

/// The sRGB code in [0, 1] of a linear value. Values outside [0, 1] are clamped; NaN gives 0.
#[inline]
pub fn encode(linear: f32) -> f32 {
    let linear = if linear > 0.0 { linear.min(1.0) } else { 0.0 };
    if linear <= KNEE as f32 {
        12.92 * linear
    } else {
        1.055 * math::pow(linear, 1.0 / 2.4) - 0.055
    }
}

/// The linear value of an sRGB code in [0, 1].
pub fn decode(code: f32) -> f32 {
    if code <= (12.92 * KNEE) as f32 {
        code / 12.92
    } else {
        math::pow((code + 0.055) / 1.055, 2.4)
    }
}

/// The 8-bit sRGB code of a linear value, rounded to the nearest.
#[inline]
pub fn encode_byte(linear: f32) -> u8 {
    (encode(linear) * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::{KNEE, decode, encode, encode_byte};

    #[test]
    fn encode_undoes_decode_on_every_byte() {
        for byte in 0..=255u8 {
            assert_eq!(encode_byte(decode(f32::from(byte) / 255.0)), byte);
        }
    }

    /// Hard case FI-03, around the knee: 2^18 floats on both sides of it.
    #[test]
    fn the_curve_never_falls_near_the_knee() {
        let falls = |encode: fn(f32) -> f32| {
            let bits = (KNEE as f32).to_bits();
            (bits - (1 << 18)..bits + (1 << 18))
                .filter(|&bits| {
                    let step = encode(f32::from_bits(bits + 1)) - encode(f32::from_bits(bits));
                    step < -f32::EPSILON / 32.0
                })
                .count()
        };
        assert_eq!(falls(encode), 0);
        assert!(falls(encode_as_printed) > 0, "the printed knee steps down");
    }

    /// The standard's own five digits.
    fn encode_as_printed(linear: f32) -> f32 {
        if linear <= 0.003_130_8 { 12.92 * linear } else { encode(linear) }
    }

    #[test]
    fn what_no_display_can_show_is_clamped() {
        assert_eq!(encode_byte(-1.0), 0);
        assert_eq!(encode_byte(1e30), 255);
        assert_eq!(encode_byte(f32::INFINITY), 255);
        assert_eq!(encode_byte(f32::NAN), 0);
    }
}
