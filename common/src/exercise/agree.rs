//! When two answers are as good as one another.
//!
//! NaN agrees with NaN here, and infinity with the same infinity: the oracle gives neither unless
//! the right answer is one, and a mistake that gives one must be recognised by it.

use glam::Vec3;

use crate::film::Film;

/// Whether the answers differ by at most `tolerance` times the size of `expected`.
pub fn close(expected: impl Into<f64>, yours: impl Into<f64>, tolerance: f64) -> bool {
    let (expected, yours) = (expected.into(), yours.into());
    within(expected, yours, tolerance * expected.abs())
}

/// Whether the answers differ by at most `tolerance`, in their own unit.
pub fn within(expected: impl Into<f64>, yours: impl Into<f64>, tolerance: f64) -> bool {
    let (expected, yours) = (expected.into(), yours.into());
    let both_nan = expected.is_nan() && yours.is_nan();
    both_nan || expected == yours || (expected - yours).abs() <= tolerance
}

/// Whether each coordinate differs by at most `tolerance` times the length of `expected`.
pub fn close_vectors(expected: Vec3, yours: Vec3, tolerance: f64) -> bool {
    let tolerance = tolerance * expected.as_dvec3().length();
    let pairs = expected.to_array().into_iter().zip(yours.to_array());
    pairs.into_iter().all(|(expected, yours)| within(expected, yours, tolerance))
}

/// Whether both are `None`, or both something that agrees.
pub fn options<T>(expected: &Option<T>, yours: &Option<T>, agree: impl Fn(&T, &T) -> bool) -> bool {
    match (expected, yours) {
        (Some(expected), Some(yours)) => agree(expected, yours),
        (None, None) => true,
        _ => false,
    }
}

/// Whether two pictures have the same size, and every channel of every pixel is within `tolerance`.
pub fn films(expected: &Film, yours: &Film, tolerance: f64) -> bool {
    let channels = |film: &Film| -> Vec<f32> {
        film.pixels.iter().flat_map(|pixel| pixel.to_array()).collect()
    };
    (expected.width, expected.height) == (yours.width, yours.height)
        && channels(expected)
            .into_iter()
            .zip(channels(yours))
            .all(|(expected, yours)| within(expected, yours, tolerance))
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::{close, close_vectors, films, options, within};
    use crate::film::{Color, Film};

    #[test]
    fn tolerance_is_relative_or_absolute() {
        assert!(close(2000.0, 2001.9, 1e-3) && !close(2000.0, 2002.1, 1e-3));
        assert!(within(2000.0, 2001.9, 2.0) && !within(2000.0, 2001.9, 1.0));
        assert!(close(0.0, -0.0, 0.0) && !close(0.0, 1e-30, 1e-3));
    }

    #[test]
    fn nan_agrees_with_nan_only() {
        assert!(within(f32::NAN, f32::NAN, 0.0) && !within(f32::NAN, 1.0, 1e30));
        assert!(!within(1.0, f32::NAN, 1e30));
        assert!(close(f32::INFINITY, f32::INFINITY, 0.0));
        assert!(!within(f32::INFINITY, f32::NEG_INFINITY, 1.0));
    }

    #[test]
    fn vectors_options_and_films() {
        let expected = Vec3::new(0.0, 3.0, 4.0);
        assert!(close_vectors(expected, Vec3::new(0.004, 3.0, 4.0), 1e-3));
        assert!(!close_vectors(expected, Vec3::new(0.006, 3.0, 4.0), 1e-3));
        assert!(options(&Some(2), &Some(3), |a, b| a + 1 == *b));
        assert!(
            !options(&Some(2), &None, |_, _| true) && options::<u8>(&None, &None, |_, _| false)
        );
        let mut film = Film::new(3, 2);
        assert!(!films(&film, &Film::new(2, 3), 1.0));
        *film.pixel_mut(2, 1) = Color::new(0.0, 0.0, 0.5);
        assert!(films(&film, &Film::new(3, 2), 0.5) && !films(&film, &Film::new(3, 2), 0.4));
    }
}
