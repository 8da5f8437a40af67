//! The solutions.

use common::film::Film;
use glam::DVec2;
use object_order::edge::{covers, edges};
use object_order::exercises::color_of;
use object_order::fixed::Fixed;
use object_order::interpolate::Interpolation;
use object_order::project::FilmPoint;

/// Exercise 3.1.
pub(crate) fn owns(from: Fixed, to: Fixed, sample: Fixed) -> bool {
    let [right, down] = [i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y)];
    let [x, y] = [i64::from(sample.x) - i64::from(from.x), i64::from(sample.y) - i64::from(from.y)];
    let value = right * y - down * x;
    let top_left = down < 0 || (down == 0 && right > 0);
    value > 0 || (value == 0 && top_left)
}

/// Exercise 3.2.
pub(crate) fn value_between(depths: [f64; 2], values: [f64; 2], share: f64) -> f64 {
    let [first, second] = [(1.0 - share) / depths[0], share / depths[1]];
    (first * values[0] + second * values[1]) / (first + second)
}

/// Exercise 3.3.
pub(crate) fn near_point(a: FilmPoint, b: FilmPoint, near: f64) -> FilmPoint {
    let (inner, outer) = if a.w >= near { (a, b) } else { (b, a) };
    let share = (inner.w - near) / (inner.w - outer.w);
    (inner.vector() + share * (outer.vector() - inner.vector())).into()
}

/// Exercise 3.4.
pub(crate) fn draw(triangles: &[[FilmPoint; 3]], width: u32, height: u32) -> Film {
    let mut nearest = vec![0.0; width as usize * height as usize];
    let mut film = Film::new(width, height);
    for (index, &corners) in triangles.iter().enumerate() {
        let snapped = corners.map(|corner| Fixed::snap(corner.divide()));
        let (Some(edges), Some(interpolation)) = (edges(snapped), Interpolation::new(corners))
        else {
            continue;
        };
        for y in 0..height {
            for x in 0..width {
                let centre = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let inverse = interpolation.inverse_depth(centre);
                let best = &mut nearest[(y * width + x) as usize];
                if covers(&edges, Fixed::snap(centre)) && inverse > *best {
                    *best = inverse;
                    *film.pixel_mut(x, y) = color_of(index);
                }
            }
        }
    }
    film
}
