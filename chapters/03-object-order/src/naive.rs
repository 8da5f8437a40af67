//! The formulas that fail, kept as negative controls.

use glam::{DVec2, Vec2};

use crate::edge::{covers, edges};
use crate::fixed::Fixed;
use crate::project::FilmPoint;

// ANCHOR: float_edges
/// Whether a triangle covers a sample, by edge functions in `f32` and with the top-left rule.
///
/// The rule needs an edge and its reverse to agree on which samples lie on it. In `f32` they round
/// differently, so a sample near the edge may be nobody's, or both neighbours'.
pub fn float_covers([a, b, c]: [Vec2; 3], sample: Vec2) -> bool {
    let value = |from: Vec2, to: Vec2| {
        (to.x - from.x) * (sample.y - from.y) - (to.y - from.y) * (sample.x - from.x)
    };
    let owns = |from: Vec2, to: Vec2| {
        let top_left = to.y < from.y || (to.y == from.y && to.x > from.x);
        let value = value(from, to);
        value > 0.0 || (value == 0.0 && top_left)
    };
    owns(a, b) && owns(b, c) && owns(c, a)
}
// ANCHOR_END: float_edges

// ANCHOR: standard_depth
/// The depth buffer value of most textbooks: 0 on the near plane and 1 on the far one.
///
/// Nearly all of [0, 1] goes to what is close to the eye, and near 1 an `f32` has no digits left.
pub fn standard_depth(near: f32, far: f32, depth: f32) -> f32 {
    far / (far - near) * (1.0 - near / depth)
}
// ANCHOR_END: standard_depth

// ANCHOR: divide_first
/// Whether a triangle covers a sample, each corner divided by its depth whatever that is.
///
/// A corner behind the eye comes out on the opposite side of the film, and one beside the eye
/// nowhere at all.
pub fn divided_covers(corners: [FilmPoint; 3], sample: Fixed) -> bool {
    let snapped = corners.map(|corner| Fixed::snap(corner.divide()));
    edges(snapped).is_some_and(|edges| covers(&edges, sample))
}
// ANCHOR_END: divide_first

// ANCHOR: affine_depth
/// A triangle's depth at a sample, as the mean of its corners' depths weighted by areas on the film.
///
/// Right only when all three corners are equally deep.
pub fn affine_depth(corners: [FilmPoint; 3], sample: DVec2) -> f64 {
    let [a, b, c] = corners.map(FilmPoint::divide);
    let area = (b - a).perp_dot(c - a);
    let second = (sample - a).perp_dot(c - a) / area;
    let third = (b - a).perp_dot(sample - a) / area;
    let first = 1.0 - second - third;
    first * corners[0].w + second * corners[1].w + third * corners[2].w
}
// ANCHOR_END: affine_depth

// ANCHOR: narrow
/// Whether a triangle covers a sample, by edge functions in 32-bit whole numbers. They wrap around.
pub fn narrow_covers([a, b, c]: [Fixed; 3], sample: Fixed) -> bool {
    let value = |from: Fixed, to: Fixed, at: Fixed| {
        let (right, down) = (to.x.wrapping_sub(from.x), to.y.wrapping_sub(from.y));
        let across = right.wrapping_mul(at.y.wrapping_sub(from.y));
        across.wrapping_sub(down.wrapping_mul(at.x.wrapping_sub(from.x)))
    };
    let [b, c] = if value(a, b, c) > 0 { [b, c] } else { [c, b] };
    let owns = |from: Fixed, to: Fixed| {
        let top_left = to.y < from.y || (to.y == from.y && to.x > from.x);
        value(from, to, sample) >= i32::from(!top_left)
    };
    owns(a, b) && owns(b, c) && owns(c, a)
}
// ANCHOR_END: narrow

#[cfg(test)]
mod tests {
    use glam::{DVec2, Vec2};

    use super::{FilmPoint, Fixed, affine_depth, divided_covers, float_covers, narrow_covers};

    #[test]
    fn all_are_right_where_nothing_is_hard() {
        let corners = [Vec2::new(1.0, 1.0), Vec2::new(7.0, 2.0), Vec2::new(2.0, 6.0)];
        let fixed = corners.map(|corner| Fixed::snap(corner.as_dvec2()));
        let film = corners.map(|corner| FilmPoint {
            x: 2.0 * f64::from(corner.x),
            y: 2.0 * f64::from(corner.y),
            w: 2.0,
        });
        for (sample, covered) in [(Vec2::splat(3.0), true), (Vec2::new(6.0, 5.0), false)] {
            let place = Fixed::snap(sample.as_dvec2());
            assert_eq!(float_covers(corners, sample), covered);
            assert_eq!(narrow_covers(fixed, place), covered);
            assert_eq!(divided_covers(film, place), covered);
        }
        assert!((affine_depth(film, DVec2::splat(3.0)) - 2.0).abs() < 1e-15);
    }
}
