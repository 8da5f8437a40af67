//! Directions to a ball far away, magnified until they fill the picture.

use common::film::{Color, Film};
use glam::{Vec2, Vec3};

use crate::naive;
use crate::points::Points;
use crate::warp::cap::Cap;

const SIDE: u32 = 360;
const GAP: u32 = 8;
const COUNT: u32 = 4096;

/// How far away the ball is, in radii.
const DISTANCE: f32 = 1500.0;

/// The textbook's formula on the left, ours on the right.
pub(super) fn picture() -> Film {
    let mut film = Film::from_fn(2 * SIDE + GAP, SIDE, |x, _| {
        Color::splat(if (SIDE..SIDE + GAP).contains(&x) { 0.5 } else { 1.0 })
    });
    let cap = Cap::of_ball(DISTANCE);
    for index in 0..COUNT {
        let u = Points::Sobol.at(index, COUNT, 1);
        mark(&mut film, 0, naive::towards_ball(DISTANCE, u));
        if let Some(cap) = cap {
            mark(&mut film, SIDE + GAP, cap.sample(u));
        }
    }
    film
}

/// A dark pixel where the direction points, in the panel that begins at column `left`.
fn mark(film: &mut Film, left: u32, direction: Vec3) {
    let place = direction.truncate() * DISTANCE * 0.47 + Vec2::splat(0.5);
    let [x, y] = (place * SIDE as f32).to_array().map(|along| (along as u32).min(SIDE - 1));
    for (x, y) in [(x, y), ((x + 1).min(SIDE - 1), y)] {
        *film.pixel_mut(left + x, y) = Color::new(0.01, 0.06, 0.3);
    }
}
