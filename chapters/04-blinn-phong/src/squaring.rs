//! Powers by multiplication alone.

use std::ops::Mul;

// ANCHOR: power
/// `base` to a whole power, by repeated squaring: two products at most for each binary digit of the
/// exponent. `one` is 1, in the type of `base`.
///
/// Each product is rounded, and each squaring doubles what was wrong: the result is wrong by up to
/// `exponent` roundings.
pub fn power<T: Copy + Mul<Output = T>>(one: T, base: T, exponent: u32) -> T {
    let (mut power, mut square, mut rest) = (one, base, exponent);
    loop {
        if rest % 2 == 1 {
            power = power * square;
        }
        rest /= 2;
        if rest == 0 {
            return power;
        }
        square = square * square;
    }
}
// ANCHOR_END: power

#[cfg(test)]
mod tests {
    use super::power;

    #[test]
    fn whole_numbers() {
        for exponent in 0..20 {
            assert_eq!(power(1u64, 7, exponent), 7u64.pow(exponent), "{exponent}");
        }
        assert_eq!(power(1.0, 0.5f32, 10), 1.0 / 1024.0);
        assert_eq!(power(1.0, 0.0f32, 0), 1.0);
    }
}
