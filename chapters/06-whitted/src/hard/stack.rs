//! WH-08, WH-13 and WH-16: very many mirrors in a row.

use std::hint::black_box;
use std::sync::atomic::{AtomicBool, Ordering};

use common::hard::Case;
use common::math;
use common::sampler::Stream;
use common::tally::{Counts, Off, Tally};

use super::CHAPTER;
use crate::facing::{Facing, series};
use crate::limits::{Limits, STOPPED_BY_DEPTH};
use crate::naive;
use crate::scatter::{Scatter, Scattered};

/// WH-08: the textbook's recursion takes a piece of the stack for each mirror.
///
/// Depths that any machine's stack holds, up to 100, and depths that none does, from 20,000: a level
/// is never as small as the 13 bytes that would fit so many into 256 KiB.
pub(super) const STACK: Case = Case {
    id: "WH-08",
    chapter: CHAPTER,
    input: "up to a million mirrors in a row, on 256 KiB of stack",
    most: 200,
    naive_fails: |trial| {
        let (mirrors, depth) = row(trial);
        let gauge = Gauge::new(mirrors, start());
        naive::radiance(&gauge, &0, depth, &mut Off);
        gauge.is_full()
    },
    robust_fails: |trial| {
        let (mirrors, depth) = row(trial);
        let gauge = Gauge::new(mirrors, start());
        let sum = Limits { depth, cutoff: 0.0 }.trace(&gauge, 0, &mut Off);
        gauge.is_full() || is_wrong(&mirrors, depth, sum.x)
    },
};

/// WH-13: sums and products of a hundred thousand `f32`.
pub(super) const ROUNDING: Case = Case {
    id: "WH-13",
    chapter: CHAPTER,
    input: "a thousand to a hundred thousand mirrors that return nearly all",
    most: 2000,
    naive_fails: |trial| {
        let (mirrors, depth) = long_row(trial);
        is_wrong(&mirrors, depth, naive::trace_in_single(&mirrors, 0, depth, &mut Off).x)
    },
    robust_fails: |trial| {
        let (mirrors, depth) = long_row(trial);
        is_wrong(&mirrors, depth, Limits { depth, cutoff: 0.0 }.trace(&mirrors, 0, &mut Off).x)
    },
};

/// WH-16: a throughput that stops shrinking. Below the smallest normal number the neighbours are as
/// far apart as the number is large, and 0.9 of the last one rounds back to it.
pub(super) const DARK: Case = Case {
    id: "WH-16",
    chapter: CHAPTER,
    input: "mirrors that return 0.3 to 0.97, until nothing is left",
    most: 1000,
    naive_fails: |trial| {
        let mirrors = dim(trial);
        naive::mirrors_until_dark(mirrors.mirror, until_dark(&mirrors)).is_none()
    },
    robust_fails: |trial| {
        let (mirrors, mut counts) = (dim(trial), Counts::default());
        let limits = Limits { depth: until_dark(&mirrors), cutoff: 0.0 };
        limits.trace(&mirrors, 0, &mut counts);
        counts.of(STOPPED_BY_DEPTH) > 0
    },
};

/// A depth at which less than 2⁻¹⁰²², the smallest normal `f64`, is left: ρⁿ is at most e to the
/// power -n (1 - ρ), and ln 2¹⁰²² is 708.4.
fn until_dark(mirrors: &Facing) -> u32 {
    (709.0 / (1.0 - f64::from(mirrors.mirror))).ceil() as u32
}

fn dim(trial: u64) -> Facing {
    Facing { light: 1.0, mirror: Stream::of_trial(616, trial).between(0.3, 0.97) }
}

/// Whether a sum is not the geometric series, rounded once to `f32`. The loop's 53 digits lose at
/// most 3 · 10⁶ roundings of 2⁻⁵³, a part in 3 · 10⁹; the last rounding may fall on either side.
fn is_wrong(mirrors: &Facing, depth: u32, sum: f32) -> bool {
    let exact = f64::from(mirrors.light) * series(f64::from(mirrors.mirror), depth);
    !((f64::from(sum) - exact).abs() <= 0.51 * f64::from(f32::EPSILON) * exact)
}

/// Mirrors, and how many of them: few or very many.
fn row(trial: u64) -> (Facing, u32) {
    let mut stream = Stream::of_trial(608, trial);
    let depth = match trial {
        0 => 1_000_000,
        trial if trial.is_multiple_of(2) => math::pow(10.0, stream.between(4.302, 6.0)) as u32,
        _ => stream.between(0.0, 100.0) as u32,
    };
    (nearly_perfect(&mut stream), depth)
}

fn long_row(trial: u64) -> (Facing, u32) {
    let mut stream = Stream::of_trial(613, trial);
    let depth = math::pow(10.0, stream.between(3.0, 5.0)) as u32;
    (nearly_perfect(&mut stream), depth)
}

/// Mirrors that lose a part in 10³ to 10⁷ of the light, and light of their own.
fn nearly_perfect(stream: &mut Stream) -> Facing {
    let lost = math::pow(10.0, stream.between(-7.0, -3.0));
    Facing { light: stream.between(0.1, 3.0), mirror: 1.0 - lost }
}

/// Mirrors that watch the stack below `start`, and end the row when 256 KiB of it are used: so a
/// recursion that would end the program can be counted as a failure.
struct Gauge {
    mirrors: Facing,
    start: usize,
    full: AtomicBool,
}

const ALLOWED: usize = 256 * 1024;

impl Gauge {
    fn new(mirrors: Facing, start: usize) -> Self {
        Self { mirrors, start, full: AtomicBool::new(false) }
    }

    fn is_full(&self) -> bool {
        self.full.load(Ordering::Relaxed)
    }
}

impl Scatter for Gauge {
    type Ray = u64;

    fn scatter<T: Tally>(&self, ray: &u64, tally: &mut T) -> Scattered<u64> {
        if self.start.abs_diff(start()) > ALLOWED {
            self.full.store(true, Ordering::Relaxed);
            return Scattered::only(common::film::Color::ZERO);
        }
        self.mirrors.scatter(ray, tally)
    }
}

/// An address in the caller's part of the stack.
#[inline(always)]
fn start() -> usize {
    let here = 0u8;
    std::ptr::from_ref(black_box(&here)).addr()
}
