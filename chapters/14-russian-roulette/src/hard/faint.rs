//! PT-02 and PT-03: paths that carry nothing, or next to nothing.
//!
//! The oracle asks for all 2²⁴ random numbers at once: as none goes on that is larger than one which
//! ends, how many go on is found by halving, and the expected value is exact.

use common::film::Color;
use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;

use super::CHAPTER;
use crate::naive::{textbook, unweighted};
use crate::roulette::{LEAST, Roulette, survive};

/// PT-02: the survival is 0, or as good as that.
pub(super) const BLACK: Case = Case {
    id: "PT-02",
    chapter: CHAPTER,
    input: "a path that carries nothing, or little: is its value kept?",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (roulette, throughput) = carried(trial);
        let probability = roulette.survival(throughput);
        is_wrong(throughput, |chance| unweighted(probability, chance))
    },
    robust_fails: |trial| {
        let (roulette, throughput) = carried(trial);
        let probability = roulette.survival(throughput);
        is_wrong(throughput, |chance| survive(probability, chance))
    },
};

/// PT-03: a survival of which 24 binary digits know nothing.
pub(super) const TINY: Case = Case {
    id: "PT-03",
    chapter: CHAPTER,
    input: "a survival from 2^-40 to 1, decided with 24 bits",
    most: UNLIMITED,
    naive_fails: |trial| {
        let throughput = faint(trial);
        is_wrong(throughput, |chance| textbook(throughput, chance))
    },
    robust_fails: |trial| {
        let throughput = faint(trial);
        let probability = Roulette { threshold: 1.0 }.survival(throughput);
        is_wrong(throughput, |chance| survive(probability, chance))
    },
};

/// A threshold, and a throughput of which each colour may be 0, subnormal, small or large.
fn carried(trial: u64) -> (Roulette, Color) {
    let mut stream = Stream::of_trial(1402, trial);
    let threshold = [0.25, 0.5, 1.0, 2.0][(stream.bits() % 4) as usize];
    let mut color = || match stream.bits() % 4 {
        0 => 0.0,
        1 => f32::from_bits(stream.bits() >> 9),
        _ => power(&mut stream, 120) * 2.0,
    };
    (Roulette { threshold }, Color::new(color(), color(), color()))
}

/// A throughput from 2⁻⁴⁰ to 1.
fn faint(trial: u64) -> Color {
    let mut stream = Stream::of_trial(1403, trial);
    let brightest = power(&mut stream, 40);
    Color::new(0.5, 1.0, 0.25) * brightest
}

/// 2 to a random power, from `-lowest` to 0, times a number from 1 to 2, halved.
fn power(stream: &mut Stream, lowest: u32) -> f32 {
    let exponent = 127 - 1 - stream.bits() % lowest;
    f32::from_bits(exponent << 23) * stream.between(1.0, 2.0)
}

/// Whether a path with this throughput counts more or less on average than before, or is no number.
fn is_wrong(throughput: Color, decide: impl Fn(f32) -> Option<f32>) -> bool {
    let chance = |number: u32| number as f32 * f32::EPSILON / 2.0;
    // Of the numbers from 0 on, the first that ends the path.
    let (mut low, mut high) = (0, 1 << 24);
    while low < high {
        let middle = (low + high) / 2;
        match decide(chance(middle)) {
            Some(_) => low = middle + 1,
            None => high = middle,
        }
    }
    let Some(factor) = decide(0.0) else { return throughput != Color::ZERO };
    let expected = f64::from(low) / f64::from(1 << 24) * f64::from(factor);
    let kept = (expected - 1.0).abs() <= f64::from(LEAST);
    !(kept && (throughput * factor).is_finite())
}

#[cfg(test)]
mod tests {
    use common::film::Color;

    use super::is_wrong;
    use crate::naive::textbook;
    use crate::roulette::{LEAST, survive};

    #[test]
    fn by_hand_596_times_too_much() {
        // One number of 2²⁴ goes on, and counts 10¹⁰.
        let factor = textbook(Color::splat(1e-10), 0.0).expect("it goes on");
        let expected = f64::from(factor) / f64::from(1 << 24);
        assert!((expected - 596.05).abs() < 0.01, "{expected}");
        assert!(is_wrong(Color::splat(1e-10), |chance| textbook(Color::splat(1e-10), chance)));
    }

    #[test]
    fn the_oracle_knows_what_is_right() {
        let gray = Color::splat(0.5);
        assert!(!is_wrong(gray, |chance| survive(0.5, chance)));
        assert!(!is_wrong(gray, |chance| survive(LEAST, chance)));
        assert!(is_wrong(gray, |chance| survive(0.5, chance).map(|factor| 1.01 * factor)));
        assert!(is_wrong(gray, |_| None), "light is lost");
        assert!(!is_wrong(Color::ZERO, |_| None));
    }
}
