//! Yours to write: the exercises of chapter 3.
//!
//! Replace the body of a function, then run
//!
//! ```sh
//! cargo test -p object-order --test exercises
//! ```

use common::film::Film;

use crate::fixed::Fixed;
use crate::project::FilmPoint;

/// Exercise 3.1, "Whose sample is it?" (section "One sample, one owner").
///
/// Says whether the edge function of the edge from `from` to `to` gives `sample` to the triangle on
/// its right hand, as the film shows it: samples right of the edge are the triangle's, samples left
/// of it are not, and samples on it are only if the edge is a left or a top one.
///
/// Coordinates are whole numbers of 1/256 pixel, y counts downwards, and all lie within 2^30 steps
/// of the film's corner. Write it without using `Edge`.
pub fn owns(from: Fixed, to: Fixed, sample: Fixed) -> bool {
    let _ = (from, to, sample);
    todo!("exercise 3.1")
}

/// Exercise 3.2, "Half way is not half way" (section "Depth between the corners").
///
/// An edge runs between two points of the scene. `depths` are their depths w, both above 0, and
/// `values` is what they carry, such as a texture coordinate. On the film, a sample lies at `share`
/// of the way from the first to the second, from 0 to 1.
///
/// Gives the value at the point of the edge that the sample shows.
pub fn value_between(depths: [f64; 2], values: [f64; 2], share: f64) -> f64 {
    let _ = (depths, values, share);
    todo!("exercise 3.2")
}

/// Exercise 3.3, "Find the mistake" (section "Cut, then divide").
///
/// Gives the point where the edge between two points crosses the near plane w = `near`. One of them
/// is nearer than that, or behind the eye; the other is beyond it. Either may come first.
///
/// A program that many books print does it so:
///
/// ```text
/// share = (near - a.w) / (b.w - a.w)
/// point = a + share * (b - a)
/// ```
///
/// The formula is right, and two triangles that share the edge still come apart. One calls it with
/// (a, b), its neighbour with (b, a). Write it so that both get the same point, to the last bit.
pub fn near_point(a: FilmPoint, b: FilmPoint, near: f64) -> FilmPoint {
    let _ = (a, b, near);
    todo!("exercise 3.3")
}

/// Exercise 3.4, "A rasterizer of your own" (section "The z-buffer").
///
/// Draws triangles on a film of `width` by `height` pixels that is black at first. Each pixel takes
/// one sample at its centre. A sample that triangle number k is nearest at gets the colour
/// `exercises::color_of(k)`; of two equally near ones the first counts. `film.pixel_mut(x, y)` is the
/// pixel to write: `*film.pixel_mut(x, y) = color_of(k)`.
///
/// All corners lie before the eye (w > 0), and corners may come in either order around their
/// triangle. No sample lies on an edge. You may use what the chapter has: `Fixed::snap`, `edges`,
/// `covers`, `Interpolation`.
pub fn draw(triangles: &[[FilmPoint; 3]], width: u32, height: u32) -> Film {
    let _ = (triangles, width, height);
    todo!("exercise 3.4")
}

/// The colour of triangle number `index` in exercise 3.4.
pub fn color_of(index: usize) -> common::film::Color {
    let shades = [[0.9, 0.35, 0.2], [0.2, 0.6, 0.9], [0.3, 0.8, 0.35], [0.95, 0.8, 0.25]];
    shades[index % shades.len()].into()
}
