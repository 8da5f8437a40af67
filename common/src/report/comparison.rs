//! Two pictures of one size, subtracted.

use crate::film::{Color, Film};
use crate::stats::error::film_rmse;

/// What NaN and infinity are shown as: magenta.
const LOUD: Color = Color::new(1.0, 0.0, 1.0);

/// The largest amplification: beyond it one sees only the rounding of `f32`.
const MOST: f32 = 1_048_576.0;

/// How two pictures of one size differ.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Pixels in all.
    pub pixels: usize,
    /// Pixels that are not the same to the last bit.
    pub differing: usize,
    /// Root mean square error over all channels; `None` when a channel is NaN or infinite.
    pub rmse: Option<f64>,
    /// Pixels of the expected picture that are NaN or infinite.
    pub nonfinite_expected: usize,
    /// The same, of the picture that is judged.
    pub nonfinite_yours: usize,
    /// The pixel with the largest error; the first of several. `None` when nothing differs.
    pub worst: Option<Worst>,
    /// The power of two that the difference is multiplied by, so that it can be seen.
    pub gain: f32,
    /// The absolute difference times `gain`; NaN where either picture is NaN or infinite.
    pub difference: Film,
}

/// A pixel, and what both pictures have there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// Column, from 0 at the left.
    pub x: u32,
    /// Row, from 0 at the top.
    pub y: u32,
    /// The colour as it should be.
    pub expected: Color,
    /// The colour that is judged.
    pub yours: Color,
    /// The largest difference of a channel; infinite where a channel is NaN or infinite.
    pub error: f32,
}

impl Comparison {
    /// Compares two pictures; `None` when their sizes differ.
    pub fn of(expected: &Film, yours: &Film) -> Option<Self> {
        if (expected.width, expected.height) != (yours.width, yours.height) {
            return None;
        }
        let pairs = || expected.pixels.iter().copied().zip(yours.pixels.iter().copied());
        let differing = pairs().filter(|(expected, yours)| !same_bits(*expected, *yours)).count();
        let largest = pairs()
            .map(|(expected, yours)| error(expected, yours))
            .filter(|error| error.is_finite())
            .fold(0.0, f32::max);
        let gain = gain(largest);
        let difference = Film::from_fn(expected.width, expected.height, |x, y| {
            amplified(expected.pixel(x, y), yours.pixel(x, y), gain)
        });
        Some(Self {
            pixels: expected.pixels.len(),
            differing,
            rmse: film_rmse(expected, yours).filter(|rmse| rmse.is_finite()),
            nonfinite_expected: nonfinite(expected),
            nonfinite_yours: nonfinite(yours),
            worst: worst(expected, yours),
            gain,
            difference,
        })
    }
}

/// The film with every NaN or infinite pixel in magenta, so that it can be seen.
pub fn visible(film: &Film) -> Film {
    Film::from_fn(film.width, film.height, |x, y| {
        let color = film.pixel(x, y);
        if color.is_finite() { color } else { LOUD }
    })
}

fn nonfinite(film: &Film) -> usize {
    film.pixels.iter().filter(|pixel| !pixel.is_finite()).count()
}

fn same_bits(expected: Color, yours: Color) -> bool {
    expected.to_array().map(f32::to_bits) == yours.to_array().map(f32::to_bits)
}

fn error(expected: Color, yours: Color) -> f32 {
    if same_bits(expected, yours) {
        0.0
    } else if expected.is_finite() && yours.is_finite() {
        (expected - yours).abs().max_element()
    } else {
        f32::INFINITY
    }
}

fn worst(expected: &Film, yours: &Film) -> Option<Worst> {
    let mut worst: Option<Worst> = None;
    for y in 0..expected.height {
        for x in 0..expected.width {
            let (expected, yours) = (expected.pixel(x, y), yours.pixel(x, y));
            let error = error(expected, yours);
            if error > worst.map_or(0.0, |worst| worst.error) {
                worst = Some(Worst { x, y, expected, yours, error });
            }
        }
    }
    worst
}

/// The largest power of two that keeps the largest error at 1 or below.
fn gain(largest: f32) -> f32 {
    let mut gain = 1.0;
    while largest > 0.0 && largest * gain * 2.0 <= 1.0 && gain < MOST {
        gain *= 2.0;
    }
    gain
}

fn amplified(expected: Color, yours: Color, gain: f32) -> Color {
    if expected.is_finite() && yours.is_finite() {
        (expected - yours).abs() * gain
    } else {
        Color::NAN
    }
}

#[cfg(test)]
mod tests {
    use super::{Comparison, LOUD, gain, visible};
    use crate::film::{Color, Film};

    fn gray(value: f32) -> Film {
        Film::from_fn(3, 2, |_, _| Color::splat(value))
    }

    #[test]
    fn the_worst_pixel_is_where_it_is() {
        let expected = gray(0.5);
        let mut yours = gray(0.5);
        yours.pixel_mut(0, 1).x = 0.375;
        yours.pixel_mut(2, 0).z = 0.75;
        let comparison = Comparison::of(&expected, &yours).unwrap();
        let worst = comparison.worst.unwrap();
        assert_eq!((worst.x, worst.y, worst.error), (2, 0, 0.25));
        assert_eq!(worst.yours, Color::new(0.5, 0.5, 0.75));
        assert_eq!((comparison.differing, comparison.pixels, comparison.gain), (2, 6, 4.0));
        assert_eq!(comparison.difference.pixel(0, 1), Color::new(0.5, 0.0, 0.0));
        assert_eq!(comparison.rmse, Some((0.078_125_f64 / 18.0).sqrt()));
    }

    #[test]
    fn nan_is_worse_than_any_number_and_leaves_the_gain_alone() {
        let mut yours = gray(0.5);
        yours.pixel_mut(0, 0).x = 0.375;
        yours.pixel_mut(1, 1).y = f32::NAN;
        let comparison = Comparison::of(&gray(0.5), &yours).unwrap();
        let worst = comparison.worst.unwrap();
        assert_eq!((worst.x, worst.y, worst.error), (1, 1, f32::INFINITY));
        assert_eq!((comparison.nonfinite_expected, comparison.nonfinite_yours), (0, 1));
        assert_eq!((comparison.gain, comparison.rmse), (8.0, None));
        assert_eq!(visible(&comparison.difference).pixel(1, 1), LOUD);
        assert_eq!(visible(&yours).pixel(0, 0), yours.pixel(0, 0));
    }

    #[test]
    fn nothing_differs_from_itself_not_even_nan() {
        let comparison = Comparison::of(&gray(f32::NAN), &gray(f32::NAN)).unwrap();
        assert_eq!((comparison.differing, comparison.worst), (0, None));
        assert_eq!(comparison.nonfinite_yours, 6);
        assert!(Comparison::of(&gray(0.0), &Film::new(2, 3)).is_none());
    }

    #[test]
    fn the_gain_shows_the_largest_error_without_clipping_it() {
        assert_eq!([0.0, 0.3, 1.0, 5.0, 1e-30].map(gain), [1.0, 2.0, 1.0, 1.0, super::MOST]);
    }
}
