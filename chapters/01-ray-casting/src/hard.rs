//! The hard cases of this chapter: inputs on which the textbook's formula fails and ours doesn't.
//!
//! A trial's number makes its input. The judge is `f64` arithmetic on the same `f32` input, or a
//! table of answers known beforehand.

mod camera;
mod direction;
mod draw;
mod plane;
mod pole;
mod rim;
mod scaling;
mod sphere;
mod table;

use common::film::{Color, Film};
use common::hard::Case;
use common::render::Settings;
use common::tally::Off;

use crate::camera::Camera;
use crate::naive::NaiveSphere;
use crate::picture::{Picture, Show};
use crate::scene::{SphereShape, far};

/// All of them, in the catalogue's order.
pub const CASES: &[Case] = &[
    direction::NORMALIZE,
    direction::PRODUCTS,
    scaling::POWER_OF_TWO,
    sphere::FAR,
    sphere::GROUND,
    sphere::NEAR_SURFACE,
    direction::LENGTHS,
    rim::RIM,
    table::ORIGINS,
    plane::GRAZING,
    camera::UPRIGHT,
    pole::LATITUDE,
    sphere::DRIFT,
];

/// This chapter, as the ledger names it.
const CHAPTER: &str = "01-ray-casting";

/// Half the distance from 1 to the next `f32`: what one rounding can do to a number near 1.
const U: f64 = f32::EPSILON as f64 / 2.0;

/// The far sphere twice: by the textbook's formula, and by ours.
pub fn picture() -> Option<Film> {
    let naive = half(|sphere| Box::new(NaiveSphere(sphere)))?;
    let stable = half(|sphere| Box::new(sphere))?;
    Some(Film::from_fn(2 * SIDE + GAP, SIDE, |x, y| {
        if x < SIDE {
            naive.pixel(x, y)
        } else if x < SIDE + GAP {
            Color::ONE
        } else {
            stable.pixel(x - SIDE - GAP, y)
        }
    }))
}

const SIDE: u32 = 400;
const GAP: u32 = 8;

fn half(sphere: SphereShape) -> Option<Film> {
    let geometry = far(sphere);
    let camera = Camera::new(&geometry.view, SIDE, SIDE).ok()?;
    let picture = Picture { geometry: &geometry, camera, show: Show::Normals };
    let settings = Settings { width: SIDE, height: SIDE, ..Settings::default() };
    Some(picture.draw::<Off>(&settings, |position| camera.ray(position)).film)
}

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    fn check(trials: u64) {
        let ledger = Ledger::of(CASES, trials);
        assert!(ledger.broken().is_empty(), "{ledger}");
    }

    #[test]
    fn the_naive_fails_and_the_robust_does_not() {
        check(100_000);
    }

    #[test]
    #[ignore = "takes minutes: cargo test --release -p ray-casting -- --ignored"]
    fn not_once_in_a_hundred_million() {
        check(100_000_000);
    }
}
