//! A logarithmic axis whose ends are both labelled.

use std::ops::Range;

/// Where an axis begins and ends, and what stands along it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    /// From one labelled end to the other; both are 1, 2 or 5 times a power of ten.
    pub(super) range: Range<f64>,
    /// The places that have a label, each once.
    pub(super) ticks: Vec<f64>,
    /// Whether the lower end stands for 0, which has no place on a logarithmic axis.
    pub(super) zero: bool,
}

impl Axis {
    /// The axis for these values, with room at both ends. Two labels are at least `gap` of its
    /// length apart.
    pub(super) fn of(values: impl Iterator<Item = f64> + Clone, gap: f64) -> Self {
        let positive = values.clone().filter(|value| *value > 0.0 && value.is_finite());
        let low = positive.clone().fold(f64::INFINITY, f64::min);
        let high = positive.fold(0.0, f64::max);
        if high == 0.0 {
            return Self { range: 0.1..10.0, ticks: vec![0.1, 1.0, 10.0], zero: true };
        }
        let zero = values.into_iter().any(|value| value <= 0.0);
        let room = if zero { ZERO_BELOW } else { ROOM_BELOW };
        let range = down(low / room)..up(high * ROOM_ABOVE);
        let ticks = ticks(&range, gap);
        Self { range, ticks, zero }
    }

    /// The label of a tick.
    pub(super) fn label(&self, value: f64) -> String {
        if self.zero && value <= self.range.start { "0".into() } else { tick(value) }
    }
}

/// A curve doesn't begin on the frame.
const ROOM_BELOW: f64 = 1.25;
/// Nor does it end there; the legend needs some room, too.
const ROOM_ABOVE: f64 = 1.8;
/// 0 is drawn well below everything else.
const ZERO_BELOW: f64 = 6.0;

/// The mantissas of round numbers.
const ROUND: [f64; 4] = [1.0, 2.0, 5.0, 10.0];

/// `value` as a number from 1 to 10 and a power of ten.
fn parts(value: f64) -> (f64, i32) {
    let text = format!("{value:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (mantissa.parse().unwrap_or(1.0), exponent.parse().unwrap_or(0))
}

fn whole(mantissa: f64, exponent: i32) -> f64 {
    format!("{mantissa}e{exponent}").parse().unwrap_or(mantissa)
}

/// The largest round number that isn't above `value`.
fn down(value: f64) -> f64 {
    let (mantissa, exponent) = parts(value);
    let round = ROUND.iter().rev().find(|&&round| round <= mantissa);
    whole(round.copied().unwrap_or(1.0), exponent)
}

/// The smallest round number that isn't below `value`.
fn up(value: f64) -> f64 {
    let (mantissa, exponent) = parts(value);
    let round = ROUND.iter().find(|&&round| round >= mantissa);
    whole(round.copied().unwrap_or(10.0), exponent)
}

/// Both ends, then the powers of ten and then other round numbers wherever there is room.
fn ticks(range: &Range<f64>, gap: f64) -> Vec<f64> {
    let place = |value: f64| libm::log(value / range.start) / libm::log(range.end / range.start);
    let mut chosen = vec![range.start, range.end];
    let (first, last) = (parts(range.start).1, parts(range.end).1);
    for mantissas in [&ROUND[..1], &ROUND[1..3]] {
        for exponent in first..=last {
            for value in mantissas.iter().map(|&mantissa| whole(mantissa, exponent)) {
                let clear = |&other: &f64| (place(value) - place(other)).abs() >= gap;
                if (range.start..range.end).contains(&value) && chosen.iter().all(clear) {
                    chosen.push(value);
                }
            }
        }
    }
    chosen.sort_by(f64::total_cmp);
    chosen
}

/// A short label for a number.
fn tick(value: f64) -> String {
    if !(0.01..1_000_000.0).contains(&value) {
        return format!("{value:.0e}");
    }
    format!("{value:.4}").trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::{Axis, down, tick, up};

    #[test]
    fn round_numbers_enclose() {
        assert_eq!([down(3.7), down(0.05), down(999.0)], [2.0, 0.05, 500.0]);
        assert_eq!([up(3.7), up(0.05), up(7e-9)], [5.0, 0.05, 1e-8]);
    }

    /// Two methods of nearly the same speed: no power of ten lies between them.
    #[test]
    fn an_axis_shorter_than_a_decade_has_both_ends_labelled() {
        let axis = Axis::of([3.1, 4.9].into_iter(), 0.1);
        assert_eq!((axis.range, axis.ticks), (2.0..10.0, vec![2.0, 5.0, 10.0]));
    }

    #[test]
    fn labels_are_apart_and_none_comes_twice() {
        for [low, high] in [[1.0, 65_536.0], [1e-12, 0.5], [0.3, 0.31], [7e-3, 2e4]] {
            let axis = Axis::of([low, high].into_iter(), 0.1);
            assert_eq!(axis.ticks.first(), Some(&axis.range.start));
            assert_eq!(axis.ticks.last(), Some(&axis.range.end));
            assert!(axis.range.start < low && axis.range.end > high);
            let mut labels: Vec<String> = axis.ticks.iter().map(|&at| axis.label(at)).collect();
            assert!((2..=11).contains(&labels.len()), "{labels:?}");
            labels.dedup();
            assert_eq!(labels.len(), axis.ticks.len(), "{labels:?}");
        }
    }

    #[test]
    fn zeros_get_a_place_below_the_smallest_error() {
        let axis = Axis::of([0.0, 0.5, 2.0].into_iter(), 0.1);
        assert!(axis.range.start < 0.5 * 0.2 && axis.range.end > 2.0);
        assert_eq!(axis.label(axis.range.start), "0");
        assert_eq!(Axis::of([0.0].into_iter(), 0.1).label(0.1), "0");
    }

    #[test]
    fn ticks_are_short() {
        assert_eq!((tick(0.1), tick(1e-7)), ("0.1".into(), "1e-7".into()));
        assert_eq!((tick(0.1 + 0.2), tick(20_000.0)), ("0.3".into(), "20000".into()));
    }
}
