//! The few transcendentals a picture needs, the same on every machine.
//!
//! IEEE 754 fixes `+ - * / sqrt` to the last bit, but not `sin`, `cos`, `tan`, `acos`, `exp`, `ln`
//! and `pow`: the platform's own versions differ between Linux, macOS and Windows (hard case X-06).
//! These come from the `libm` crate, which is plain Rust arithmetic and so gives the same bits
//! everywhere. Angles are in radians.

/// Sine.
#[inline]
pub fn sin(angle: f32) -> f32 {
    libm::sinf(angle)
}

/// Cosine.
#[inline]
pub fn cos(angle: f32) -> f32 {
    libm::cosf(angle)
}

/// Sine and cosine together, which takes less time than both one by one; the same numbers.
#[inline]
pub fn sin_cos(angle: f32) -> (f32, f32) {
    libm::sincosf(angle)
}

/// Tangent.
#[inline]
pub fn tan(angle: f32) -> f32 {
    libm::tanf(angle)
}

/// Arc cosine, in [0, π]; NaN outside [-1, 1].
#[inline]
pub fn acos(cosine: f32) -> f32 {
    libm::acosf(cosine)
}

/// The angle of the point (x, y), in [-π, π].
#[inline]
pub fn atan2(y: f32, x: f32) -> f32 {
    libm::atan2f(y, x)
}

/// `base` to the power `exponent`; NaN for a negative base and a fractional exponent.
#[inline]
pub fn pow(base: f32, exponent: f32) -> f32 {
    libm::powf(base, exponent)
}

/// The logarithm of `x` to the base 10.
#[inline]
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// `a*b - c*d` with the error of both products put back: right to 1.5 units in the last place
/// however much cancels (hard case X-07).
///
/// Kahan's algorithm; see Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for
/// the accurate computation of 2x2 determinants" (Mathematics of Computation 82, 2013).
#[inline]
pub fn difference_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    let cd = c * d;
    let difference = a.mul_add(b, -cd);
    let error = (-c).mul_add(d, cd);
    difference + error
}

#[cfg(test)]
mod tests {
    use super::{acos, atan2, cos, difference_of_products, pow, sin, sin_cos, tan};

    /// Hard case X-06: these bits hold on every machine, or a picture would not. Each is also the
    /// float nearest to the true value, found with 53-bit arithmetic elsewhere.
    #[test]
    fn the_bits_are_pinned() {
        let bits = [
            sin(0.000_443_632_98).to_bits(),
            cos(1.0).to_bits(),
            tan(0.611_111).to_bits(),
            acos(0.3).to_bits(),
            atan2(-1.0, -3.0).to_bits(),
            pow(0.7, 2.2).to_bits(),
        ];
        assert_eq!(bits.map(|bits| format!("{bits:08x}")), PINNED);
    }

    #[test]
    fn both_together_are_each_alone() {
        for bits in (0..=f32::INFINITY.to_bits()).step_by(4099) {
            let angle = f32::from_bits(bits);
            for angle in [angle, -angle] {
                let (sine, cosine) = sin_cos(angle);
                let both = [sine, cosine].map(f32::to_bits);
                assert_eq!(both, [sin(angle), cos(angle)].map(f32::to_bits), "{angle:e}");
            }
        }
    }

    const PINNED: [&str; 6] =
        ["39e89768", "3f0a5140", "3f3358cf", "3fa20faf", "c034784b", "3ee99b5c"];

    #[test]
    fn products_that_nearly_cancel() {
        let a = 1.0 + f32::EPSILON;
        let b = 1.0 - f32::EPSILON;
        let exact = f64::from(a) * f64::from(b) - 1.0;
        assert_eq!(f64::from(difference_of_products(a, b, 1.0, 1.0)), exact);
        assert_eq!(a * b - 1.0, 0.0, "the naive form has nothing left");
    }
}
