//! The hard cases of what happens to a picture after its light is known: averages, codes, order.

use crate::film::{Color, Mean, srgb};
use crate::hard::{Case, UNLIMITED};
use crate::math;
use crate::render::{Settings, render};
use crate::sampler::{Purpose, Sampler, Stream};

const SEED: u64 = 0x0f11;

/// The cases, in the order of the catalogue.
pub const CASES: [Case; 7] = [
    Case {
        id: "X-05",
        chapter: "common",
        input: "a NaN among a pixel's samples",
        most: UNLIMITED,
        naive_fails: clamping_hides_nan,
        robust_fails: mean_hides_nan,
    },
    Case {
        id: "X-07",
        chapter: "common",
        input: "a b - c d, nearly equal products",
        most: UNLIMITED,
        naive_fails: |trial| product_error(trial, |p| p.a * p.b - p.c * p.d),
        robust_fails: |trial| {
            product_error(trial, |p| math::difference_of_products(p.a, p.b, p.c, p.d))
        },
    },
    Case {
        id: "FI-01",
        chapter: "common",
        input: "2^25 equal samples in one pixel",
        most: 4,
        naive_fails: sum_in_f32_drifts,
        robust_fails: mean_drifts,
    },
    Case {
        id: "FI-02",
        chapter: "common",
        input: "a running mean of 2^22 samples",
        most: 4,
        naive_fails: running_mean_in_f32_drifts,
        robust_fails: mean_of_noise_drifts,
    },
    Case {
        id: "FI-03",
        chapter: "common",
        input: "neighbours around the knee of sRGB",
        most: 1 << 20,
        naive_fails: |trial| falls(trial, encode_as_printed),
        robust_fails: |trial| falls(trial, srgb::encode),
    },
    Case {
        id: "FI-05",
        chapter: "common",
        input: "one picture by 2 to 12 threads",
        most: 11,
        naive_fails: shared_sums_differ,
        robust_fails: pictures_differ,
    },
    Case {
        id: "FI-07",
        chapter: "common",
        input: "a pixel without a finite sample",
        most: 3,
        naive_fails: |trial| !weighted(trial as u32).is_finite(),
        robust_fails: |trial| !mean_of_bad(trial as u32).color().is_finite(),
    },
];

/// A finite sample, but for a NaN in a channel that the trial chooses.
fn sample_with_nan(trial: u64) -> Color {
    let mut color = Stream::of_trial(SEED, trial).uniform() * Color::ONE;
    color[(trial % 3) as usize] = f32::NAN;
    color
}

/// The way from float to byte that many programs take: `as` turns a NaN into an ordinary black.
fn clamping_hides_nan(trial: u64) -> bool {
    let bytes =
        sample_with_nan(trial).to_array().map(|value| (value.clamp(0.0, 1.0) * 255.0) as u8);
    bytes[(trial % 3) as usize] == 0
}

fn mean_hides_nan(trial: u64) -> bool {
    let mut mean = Mean::default();
    mean.add(sample_with_nan(trial));
    mean.nonfinite() != 1
}

/// Factors of two products that agree in all but the last few bits.
struct Products {
    a: f32,
    b: f32,
    c: f32,
    d: f32,
}

fn products(trial: u64) -> Products {
    let mut stream = Stream::of_trial(SEED, trial);
    let a = stream.between(1.0, 10.0);
    let b = stream.between(1.0, 10.0);
    Products { a, b, c: a * stream.between(1.0 - 5e-7, 1.0 + 5e-7), d: b }
}

/// Whether a difference of products is off by more than two units in the last place.
fn product_error(trial: u64, difference: fn(&Products) -> f32) -> bool {
    let p = products(trial);
    let exact = f64::from(p.a) * f64::from(p.b) - f64::from(p.c) * f64::from(p.d);
    let error = f64::from(difference(&p)) - exact;
    error.abs() > exact.abs() * 2.0 * f64::from(f32::EPSILON)
}

const MANY: u32 = 1 << 25;

/// The samples' value in this trial; all samples are equal, so it is their mean too.
fn value(trial: u64) -> f32 {
    Stream::of_trial(SEED, trial).between(0.5, 1.0)
}

fn off(mean: f32, exact: f32) -> bool {
    (mean - exact).abs() > 1e-6 * exact
}

fn sum_in_f32_drifts(trial: u64) -> bool {
    let value = value(trial);
    let sum = (0..MANY).fold(0.0_f32, |sum, _| sum + value);
    off(sum / MANY as f32, value)
}

fn mean_drifts(trial: u64) -> bool {
    let mut mean = Mean::default();
    for _ in 0..MANY {
        mean.add(Color::splat(value(trial)));
    }
    off(mean.color().x, value(trial))
}

const SEVERAL: u32 = 1 << 22;

/// The samples of the trial and, from their exact integer sum, their mean.
fn noise(trial: u64) -> (impl Iterator<Item = f32>, f32) {
    let samples = move || {
        let mut stream = Stream::of_trial(SEED, trial);
        (0..SEVERAL).map(move |_| stream.uniform())
    };
    let sum: u64 = samples().map(|sample| (sample * 16_777_216.0) as u64).sum();
    (samples(), (sum as f64 / f64::from(SEVERAL) / 16_777_216.0) as f32)
}

fn running_mean_in_f32_drifts(trial: u64) -> bool {
    let (samples, exact) = noise(trial);
    let step = |mean: f32, (n, sample): (u32, f32)| mean + (sample - mean) / n as f32;
    off((1..).zip(samples).fold(0.0, step), exact)
}

fn mean_of_noise_drifts(trial: u64) -> bool {
    let (samples, exact) = noise(trial);
    let mut mean = Mean::default();
    samples.for_each(|sample| mean.add(Color::splat(sample)));
    off(mean.color().x, exact)
}

/// Whether the code of a linear value is above that of the next larger one, by more than the one
/// unit in the last place that rounding may cost.
fn falls(trial: u64, encode: fn(f32) -> f32) -> bool {
    let bits = 0.003_130_8_f32.to_bits() - (1 << 19) + trial as u32;
    let step = encode(f32::from_bits(bits + 1)) - encode(f32::from_bits(bits));
    step < -f32::EPSILON / 32.0
}

/// The curve with the five digits of its knee that the standard prints.
fn encode_as_printed(linear: f32) -> f32 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * math::pow(linear, 1.0 / 2.4) - 0.055
    }
}

const LIGHT: Purpose = Purpose::named("hard case FI-05");

/// A pixel's samples, shared out to so many threads, each with a sum of its own.
fn shared_sum(threads: u32) -> f32 {
    let sample = |index| Sampler::new(SEED, 0, index, 1000).stream(0, LIGHT).uniform();
    let part = |thread| (thread..1000).step_by(threads as usize).map(sample).sum::<f32>();
    (0..threads).map(part).sum()
}

fn shared_sums_differ(trial: u64) -> bool {
    shared_sum(trial as u32 + 2) != shared_sum(1)
}

fn picture(threads: usize) -> u64 {
    let settings = Settings { width: 33, height: 19, spp: 4, threads, ..Settings::default() };
    render(&settings, |_, sampler| Color::splat(sampler.stream(0, LIGHT).uniform())).film.hash()
}

fn pictures_differ(trial: u64) -> bool {
    picture(trial as usize + 2) != picture(1)
}

/// The textbook average: what was summed over how often, though that be never.
fn weighted(_bad_samples: u32) -> f32 {
    let (sum, weight) = (0.0_f32, 0.0_f32);
    sum / weight
}

fn mean_of_bad(bad_samples: u32) -> Mean {
    let mut mean = Mean::default();
    (0..bad_samples).for_each(|_| mean.add(Color::INFINITY));
    mean
}

#[cfg(test)]
mod tests {
    use super::CASES;
    use crate::film::srgb;
    use crate::hard::Ledger;

    #[test]
    fn naive_fails_and_robust_does_not() {
        let ledger = Ledger::of(&CASES, 1 << 20);
        assert!(ledger.broken().is_empty(), "{ledger}");
    }

    /// FI-06: Rust never fuses a multiplication and an addition on its own, so bits don't depend on
    /// the target's instructions.
    #[test]
    fn nothing_is_fused_unless_asked_for() {
        let a = std::hint::black_box(1.0 + f32::EPSILON * 2048.0);
        let b = std::hint::black_box(1.0 + f32::EPSILON * 4096.0);
        assert_eq!(a * a - b, 0.0);
        assert_eq!(a.mul_add(a, -b), 5.960_464_5e-8);
    }

    /// FI-03 in full: every float from 0 to 1, about a billion of them. The bytes come from a table,
    /// which can't fall; here the curve itself, rounded, says the same of each float.
    #[test]
    #[ignore = "takes half a minute; run with -- --ignored"]
    fn the_byte_never_falls_over_all_floats_from_0_to_1() {
        use rayon::prelude::{IntoParallelIterator, ParallelIterator};
        let differs = |bits: &u32| {
            let linear = f32::from_bits(*bits);
            srgb::encode_byte(linear) != (srgb::encode(linear) * 255.0 + 0.5) as u8
        };
        assert_eq!((0..=1.0_f32.to_bits()).into_par_iter().filter(differs).count(), 0);
    }
}
