//! How far an estimate is from its reference.

use crate::film::Film;

/// What keeps the relative error finite where the reference is black.
const FLOOR: f64 = 0.01;

/// The mean squared error of `estimate` against `reference`, in the unit of both, squared.
///
/// `None` when the lengths differ or both are empty.
pub fn mse(reference: &[f64], estimate: &[f64]) -> Option<f64> {
    weighted(reference, estimate, |_| 1.0)
}

/// The root of the mean squared error, in the unit of both; `None` as for [`mse`].
pub fn rmse(reference: &[f64], estimate: &[f64]) -> Option<f64> {
    mse(reference, estimate).map(f64::sqrt)
}

/// The mean squared error, each term weighted by 1 / (reference² + 0.01): dark parts count as much
/// as bright ones, and black doesn't divide by zero. `None` as for [`mse`].
///
/// Fabrice Rousselle, Claude Knaus and Matthias Zwicker, "Adaptive sampling and reconstruction
/// using greedy error minimization" (ACM Transactions on Graphics 30, 2011).
pub fn relative_mse(reference: &[f64], estimate: &[f64]) -> Option<f64> {
    weighted(reference, estimate, |reference| 1.0 / (reference * reference + FLOOR))
}

/// [`rmse`] over all three channels of two pictures; `None` when their sizes differ.
pub fn film_rmse(reference: &Film, film: &Film) -> Option<f64> {
    of_films(reference, film, rmse)
}

/// [`relative_mse`] over all three channels of two pictures; `None` when their sizes differ.
pub fn film_relative_mse(reference: &Film, film: &Film) -> Option<f64> {
    of_films(reference, film, relative_mse)
}

fn of_films(
    reference: &Film,
    film: &Film,
    metric: fn(&[f64], &[f64]) -> Option<f64>,
) -> Option<f64> {
    let same_size = (reference.width, reference.height) == (film.width, film.height);
    if same_size { metric(&channels(reference), &channels(film)) } else { None }
}

/// The red, green and blue of every pixel, one after the other.
fn channels(film: &Film) -> Vec<f64> {
    film.pixels.iter().flat_map(|pixel| pixel.to_array().map(f64::from)).collect()
}

fn weighted(reference: &[f64], estimate: &[f64], weight: impl Fn(f64) -> f64) -> Option<f64> {
    if reference.len() != estimate.len() || reference.is_empty() {
        return None;
    }
    let sum: f64 = reference
        .iter()
        .zip(estimate)
        .map(|(reference, estimate)| {
            let error = estimate - reference;
            error * error * weight(*reference)
        })
        .sum();
    Some(sum / reference.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::{film_relative_mse, film_rmse, mse, relative_mse, rmse};
    use crate::film::{Color, Film};

    #[test]
    fn three_and_four_make_five() {
        assert_eq!(mse(&[1.0, 2.0], &[4.0, -2.0]), Some(12.5));
        assert_eq!(rmse(&[1.0, 2.0, 7.0, 7.0], &[4.0, -2.0, 7.0, 7.0]), Some(2.5));
    }

    #[test]
    fn relative_error_counts_dark_and_bright_alike() {
        // 10 % too much of 10 and of 1000: both terms are 0.01, but for the floor.
        let bright = relative_mse(&[1000.0], &[1100.0]).unwrap();
        let dark = relative_mse(&[10.0], &[11.0]).unwrap();
        assert!((bright - dark).abs() < 2e-6);
        assert_eq!(relative_mse(&[0.0], &[0.5]), Some(0.25 / 0.01));
    }

    #[test]
    fn films_of_different_sizes_have_no_error() {
        let wide = Film::new(3, 2);
        assert_eq!(film_rmse(&wide, &Film::new(2, 3)), None);
        assert_eq!(film_relative_mse(&wide, &Film::new(3, 1)), None);
        assert_eq!(rmse(&[], &[]), None);
    }

    #[test]
    fn all_three_channels_count() {
        let mut film = Film::new(3, 2);
        *film.pixel_mut(2, 1) = Color::new(1.0, 2.0, 2.0);
        // The squares 1 + 4 + 4, over 18 channels.
        assert_eq!(film_rmse(&Film::new(3, 2), &film), Some(0.5_f64.sqrt()));
    }
}
