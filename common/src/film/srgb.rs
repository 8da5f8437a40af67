//! From linear light to the numbers a display takes, and back (IEC 61966-2-1, sRGB).

use std::sync::LazyLock;

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
///
/// The curve only rises, so a byte begins at one float and goes on to where the next begins. To look
/// it up among these 255 beginnings takes less time than a power, and the two answers are one.
#[inline]
pub fn encode_byte(linear: f32) -> u8 {
    BEGINNINGS.partition_point(|&beginning| beginning <= linear) as u8
}

/// The least linear value of every byte from 1 to 255.
static BEGINNINGS: LazyLock<[f32; 255]> = LazyLock::new(|| {
    let mut begins = 0.0_f32.to_bits();
    std::array::from_fn(|before| {
        begins = first(begins, 1.0_f32.to_bits(), |bits| {
            usize::from(rounded_byte(f32::from_bits(bits))) > before
        });
        f32::from_bits(begins)
    })
});

/// The code by the curve itself.
fn rounded_byte(linear: f32) -> u8 {
    (encode(linear) * 255.0 + 0.5) as u8
}

/// The first of `low..=high` that `is_past`, which holds for `high` and, once it holds, goes on to.
fn first(mut low: u32, mut high: u32, is_past: impl Fn(u32) -> bool) -> u32 {
    while low < high {
        let middle = low.midpoint(high);
        if is_past(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::{KNEE, decode, encode, encode_byte, rounded_byte};

    #[test]
    fn encode_undoes_decode_on_every_byte() {
        for byte in 0..=255u8 {
            assert_eq!(encode_byte(decode(f32::from(byte) / 255.0)), byte);
        }
    }

    /// Each byte's first float, and the one before it, are what the curve says; and with them, as it
    /// never falls, all between. Every 997th float is asked as well.
    #[test]
    fn the_table_says_what_the_curve_says() {
        let same = |bits: u32| {
            let linear = f32::from_bits(bits);
            assert_eq!(encode_byte(linear), rounded_byte(linear), "{linear:e}");
        };
        for beginning in *super::BEGINNINGS {
            same(beginning.to_bits());
            same(beginning.to_bits() - 1);
        }
        (0..=f32::INFINITY.to_bits()).step_by(997).for_each(same);
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
