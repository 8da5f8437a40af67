//! BP-02: cosines that rounding carried out of [0, 1], and large or fractional exponents.

use common::hard::{Case, UNLIMITED};
use common::math;
use common::sampler::Stream;

use super::{CHAPTER, U};
use crate::models::lobe;
use crate::squaring;

/// BP-02: cosⁿ.
pub(super) const POWER: Case = Case {
    id: "BP-02",
    chapter: CHAPTER,
    input: "any cosine of f32 from -1.001 to 1.001, five exponents",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (cosine, exponent) = drawn(trial);
        is_wrong(cosine, exponent, math::pow)
    },
    robust_fails: |trial| {
        let (cosine, exponent) = drawn(trial);
        is_wrong(cosine, exponent, lobe)
    },
};

/// Exponents that are nothing, one, fractional, large and huge.
const EXPONENTS: [Exponent; 5] = [
    Exponent { n: 0.0, power: |_| 0.0 },
    Exponent { n: 1.0, power: |cosine| cosine },
    Exponent { n: 2.5, power: |cosine| cosine * cosine * cosine.sqrt() },
    Exponent { n: 1e3, power: |cosine| squaring::power(1.0, cosine, 1000) },
    Exponent { n: 1e6, power: |cosine| squaring::power(1.0, cosine, 1_000_000) },
];

/// An exponent, and what it makes of a cosine in [0, 1] without a power function: in `f64`, by
/// products and a root. Rounded a million times, the millionth power still has ten digits.
#[derive(Clone, Copy)]
struct Exponent {
    n: f32,
    power: fn(f64) -> f64,
}

/// The largest cosine asked for, in whole steps of `f32` above 0.
const STEPS: u32 = 1.001f32.to_bits();

/// Two of three cosines have any bits there are from -1.001 to 1.001, which makes most of them tiny;
/// the third lies near 1, where highlights are.
fn drawn(trial: u64) -> (f32, Exponent) {
    let mut stream = Stream::of_trial(402, trial);
    let exponent = EXPONENTS[(trial % 5) as usize];
    let any = f32::from_bits(stream.bits() % (STEPS + 1));
    let near_one = f32::from_bits(STEPS - stream.bits() % (1 << 15));
    let cosine = match stream.bits() % 3 {
        0 => any,
        1 => -any,
        _ => near_one,
    };
    (cosine, exponent)
}

/// A highlight is from 0 to 1; it is 0 behind the surface and for an exponent of 0; and else it is
/// the power of the cosine, or of 1 if rounding made more of it.
///
/// To one unit in the last place, which both power functions promise; or to one step between the
/// smallest numbers.
fn is_wrong(cosine: f32, Exponent { n, power }: Exponent, highlight: fn(f32, f32) -> f32) -> bool {
    let found = highlight(cosine, n);
    if !(0.0..=1.0).contains(&found) {
        return true;
    }
    if !(cosine > 0.0) {
        return found != 0.0;
    }
    let exact = power(f64::from(cosine).min(1.0));
    !((f64::from(found) - exact).abs() <= 2.0 * U * exact + 1.5e-45)
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::{EXPONENTS, STEPS, is_wrong};
    use crate::models::lobe;

    /// How many cosines with these steps above 0, and below, come out wrong for some exponent.
    fn wrong(steps: impl Iterator<Item = u32>) -> usize {
        let cosines = steps.flat_map(|bits| [f32::from_bits(bits), -f32::from_bits(bits)]);
        let asked = cosines.flat_map(|cosine| EXPONENTS.map(|exponent| (cosine, exponent)));
        asked.filter(|&(cosine, exponent)| is_wrong(cosine, exponent, lobe)).count()
    }

    #[test]
    fn every_hundred_thousandth_cosine() {
        assert_eq!(wrong((0..=STEPS).step_by(99_991)), 0);
    }

    /// 2.1 thousand million cosines, five exponents each.
    #[test]
    #[ignore = "takes ten minutes: cargo test --release -p blinn-phong -- --ignored every_cosine"]
    fn every_cosine_there_is() {
        thread::scope(|scope| {
            let lower = scope.spawn(|| wrong(0..STEPS / 2));
            assert_eq!(wrong(STEPS / 2..STEPS + 1), 0);
            assert_eq!(lower.join().expect("it counts"), 0);
        });
    }
}
