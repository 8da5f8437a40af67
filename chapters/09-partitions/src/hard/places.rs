//! AC-07 and AC-09: middles of cells, and cells of coordinates.

use common::sampler::Stream;

use crate::cells::Side;
use crate::naive;
use crate::plant::Span;

/// A cell whose ends are a few floats apart, or far out.
fn cell(trial: u64) -> Span {
    let mut stream = Stream::of_trial(907, trial);
    let sign = if stream.uniform() < 0.5 { -1.0 } else { 1.0 };
    match trial % 3 {
        // Neighbours, or up to seven floats between; one in 25 is so small that it has no exponent.
        0 => {
            let all = if trial.is_multiple_of(25) { 1 << 22 } else { 0x7f00_0000 };
            let bits = stream.bits() % all;
            let [low, high] = [0, 1 + stream.bits() % 8].map(|step| f32::from_bits(bits + step));
            if sign > 0.0 { Span { low, high } } else { Span { low: -high, high: -low } }
        }
        1 => {
            let [one, other] = [0, 1].map(|_| sign * f32::MAX * stream.between(0.25, 1.0));
            Span { low: one.min(other), high: one.max(other) }
        }
        _ => Span { low: -f32::MAX * stream.uniform(), high: f32::MAX * stream.uniform() },
    }
}

/// Whether `middle` is outside the cell, or at an end although there are floats between.
fn is_wrong(Span { low, high }: Span, middle: f32) -> bool {
    let between = low < middle && middle < high;
    let room = low.next_up() < high;
    if room { !between } else { !(low <= middle && middle <= high) }
}

pub(super) fn middle_naive(trial: u64) -> bool {
    let span = cell(trial);
    is_wrong(span, naive::middle(span.low, span.high))
}

pub(super) fn middle_robust(trial: u64) -> bool {
    let span = cell(trial);
    is_wrong(span, span.middle())
}

/// A side cut into cells, and a coordinate in it, near one of the ends.
fn place(trial: u64) -> (Side, f32, f32) {
    let mut stream = Stream::of_trial(909, trial);
    let low = [0.0_f32, 1e6, -3.0, 1e-3, -70_000.0][trial as usize % 5];
    let high = low + low.abs().max(1.0) * [1e-6, 1.0, 0.3, 17.0][trial as usize / 5 % 4];
    let high = high.max(low.next_up());
    let count = 1 + (stream.bits() % 300) as i32;
    let steps = stream.bits() % 300;
    let mut coordinate = if stream.uniform() < 0.5 { low } else { high };
    let inward = if coordinate == low { f32::next_up } else { f32::next_down };
    for _ in 0..steps {
        let next = inward(coordinate);
        if low <= next && next <= high {
            coordinate = next;
        }
    }
    (Side::new(low, high, count), coordinate, high)
}

/// Whether a cell isn't there, or the coordinate isn't in it, give or take four roundings: of two
/// differences, a quotient and a product.
fn is_elsewhere(side: &Side, high: f32, coordinate: f32, index: i32) -> bool {
    let exact = |part: f64| {
        f64::from(side.low) + (f64::from(high) - f64::from(side.low)) * part / f64::from(side.count)
    };
    let slack = 2.0 * f64::from(f32::EPSILON) * (f64::from(high) - f64::from(side.low)).abs();
    let [begins, ends] = [index, index + 1].map(|border| exact(f64::from(border)));
    let coordinate = f64::from(coordinate);
    !(0..side.count).contains(&index) || coordinate < begins - slack || coordinate > ends + slack
}

pub(super) fn index_naive(trial: u64) -> bool {
    let (side, coordinate, high) = place(trial);
    is_elsewhere(&side, high, coordinate, naive::index(coordinate, side.low, high, side.count))
}

pub(super) fn index_robust(trial: u64) -> bool {
    let (side, coordinate, high) = place(trial);
    let next = coordinate.next_up().min(high);
    is_elsewhere(&side, high, coordinate, side.index(coordinate))
        || side.index(next) < side.index(coordinate)
}
