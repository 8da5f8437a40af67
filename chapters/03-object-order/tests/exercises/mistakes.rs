//! What readers get wrong.

use common::exercise::Mistake;
use common::film::Film;
use glam::DVec2;
use object_order::edge::{covers, edges};
use object_order::exercises::color_of;
use object_order::fixed::Fixed;
use object_order::interpolate::Interpolation;
use object_order::naive::affine_depth;
use object_order::project::FilmPoint;

use crate::{Cut, Draw, Edge, Stretch};

/// Of exercise 3.1.
pub(crate) fn owns() -> Vec<Mistake<Edge, bool>> {
    vec![
        Mistake {
            name: "no fill rule",
            diagnosis: "You keep every sample on the edge. The neighbour across the edge does so \
                        too, and both own it. Keep it only for a left or a top edge.",
            answer: |edge| value(edge) >= 0,
        },
        Mistake {
            name: "nobody's edge",
            diagnosis: "You drop every sample on the edge. The neighbour across the edge does so \
                        too, and nobody owns it: a hole. Keep it for a left or a top edge.",
            answer: |edge| value(edge) > 0,
        },
        Mistake {
            name: "y counts upwards",
            diagnosis: "Your rule keeps right and bottom edges. Rows count downwards on the film: a \
                        left edge goes up, so its y gets smaller.",
            answer: |edge| value(edge) > 0 || (value(edge) == 0 && !top_left(edge)),
        },
        Mistake {
            name: "32 bits",
            diagnosis: "Your products overflow: two differences of up to 2^31 steps multiply to \
                        2^62. Convert to i64 before you subtract and multiply.",
            answer: |Edge { from, to, sample }| {
                let right = to.x.wrapping_sub(from.x);
                let down = to.y.wrapping_sub(from.y);
                let left_part = right.wrapping_mul(sample.y.wrapping_sub(from.y));
                let value =
                    left_part.wrapping_sub(down.wrapping_mul(sample.x.wrapping_sub(from.x)));
                value > 0 || (value == 0 && (down < 0 || (down == 0 && right > 0)))
            },
        },
        Mistake {
            name: "32 bits, with a panic",
            diagnosis: OVERFLOW,
            answer: |edge| {
                let value = narrow_value(edge);
                value > 0 || (value == 0 && top_left(edge))
            },
        },
        Mistake {
            name: "32 bits and no fill rule",
            diagnosis: OVERFLOW_AND_NO_RULE,
            answer: |edge| narrow_value(edge) >= 0,
        },
        Mistake {
            name: "differences in 32 bits",
            diagnosis: OVERFLOW,
            answer: |edge| {
                let value = late_value(edge);
                value > 0 || (value == 0 && top_left(edge))
            },
        },
        Mistake {
            name: "differences in 32 bits and no fill rule",
            diagnosis: OVERFLOW_AND_NO_RULE,
            answer: |edge| late_value(edge) >= 0,
        },
    ]
}

const OVERFLOW: &str = "Your arithmetic overflows and panics: two points can be 2^31 steps apart, \
                        and products reach 2^62. Convert to i64 before you subtract, not after it.";

const OVERFLOW_AND_NO_RULE: &str = "You have two mistakes. Your arithmetic overflows: convert to i64 \
                        before you subtract. And you keep every sample on the edge, as the \
                        neighbour across it does: keep it only for a left or a top edge.";

/// The difference of two coordinates in an i32, with the panic that a debug build has.
fn narrow(from: i32, to: i32) -> i32 {
    to.checked_sub(from).expect("the difference overflows")
}

/// The edge function in i32, with the panic that a debug build has.
fn narrow_value(Edge { from, to, sample }: &Edge) -> i32 {
    let product = |a: i32, b: i32| a.checked_mul(b).expect("the product overflows");
    let first = product(narrow(from.x, to.x), narrow(from.y, sample.y));
    let second = product(narrow(from.y, to.y), narrow(from.x, sample.x));
    first.checked_sub(second).expect("the difference overflows")
}

/// The edge function with differences in i32 and products in i64.
fn late_value(Edge { from, to, sample }: &Edge) -> i64 {
    let late = |from: i32, to: i32| i64::from(narrow(from, to));
    late(from.x, to.x) * late(from.y, sample.y) - late(from.y, to.y) * late(from.x, sample.x)
}

fn value(Edge { from, to, sample }: &Edge) -> i128 {
    let wide = |from: i32, to: i32| i128::from(to) - i128::from(from);
    wide(from.x, to.x) * wide(from.y, sample.y) - wide(from.y, to.y) * wide(from.x, sample.x)
}

fn top_left(Edge { from, to, .. }: &Edge) -> bool {
    to.y < from.y || (to.y == from.y && to.x > from.x)
}

/// Of exercise 3.2.
pub(crate) fn value_between() -> Vec<Mistake<Stretch, f64>> {
    vec![
        Mistake {
            name: "affine",
            diagnosis: "You took the same share of the value as of the film. That is right only \
                        when both ends are equally deep: what is linear on the film is value / w.",
            answer: |Stretch { values: [a, b], share, .. }| a + share * (b - a),
        },
        Mistake {
            name: "not divided by 1/w",
            diagnosis: "You interpolated value / w and stopped there. Divide by the 1/w that you \
                        interpolate in the same way.",
            answer: |Stretch { depths, values, share }| {
                (1.0 - share) * values[0] / depths[0] + share * values[1] / depths[1]
            },
        },
        Mistake {
            name: "multiplied by w",
            diagnosis: "You weighted the ends by w. The nearer end fills more of the film and must \
                        weigh more: weigh by 1/w.",
            answer: |Stretch { depths, values, share }| {
                let [first, second] = [(1.0 - share) * depths[0], share * depths[1]];
                (first * values[0] + second * values[1]) / (first + second)
            },
        },
        Mistake {
            name: "linear depth below the division",
            diagnosis: "You interpolated value / w rightly and then multiplied by a w that you \
                        interpolated on the film. It is 1/w that is linear there, not w.",
            answer: |Stretch { depths, values, share }| {
                let over = (1.0 - share) * values[0] / depths[0] + share * values[1] / depths[1];
                over * (depths[0] + share * (depths[1] - depths[0]))
            },
        },
    ]
}

const ORDER: &str = "Your formula is right, but (a, b) and (b, a) round differently: the two \
                        triangles at this edge get two points, and a sample can fall between them. \
                        Always go from the inner end to the outer one.";

/// Of exercise 3.3.
pub(crate) fn near_point() -> Vec<Mistake<Cut, [FilmPoint; 2]>> {
    vec![
        Mistake {
            name: "in the order they come",
            diagnosis: ORDER,
            answer: |cut| cut.both(printed),
        },
        Mistake {
            name: "in the order they come, on the plane",
            diagnosis: ORDER,
            answer: |cut| cut.both(|a, b, near| FilmPoint { w: near, ..printed(a, b, near) }),
        },
        Mistake {
            name: "in the order they come, mixed",
            diagnosis: ORDER,
            answer: |cut| cut.both(mixed),
        },
        Mistake {
            name: "in the order they come, mixed, on the plane",
            diagnosis: ORDER,
            answer: |cut| cut.both(|a, b, near| FilmPoint { w: near, ..mixed(a, b, near) }),
        },
        Mistake {
            name: "the share of the other end",
            diagnosis: "You measured the share from one end and went that far from the other one.",
            answer: |cut| {
                cut.both(|a, b, near| {
                    let (inner, outer) = if a.w >= near { (a, b) } else { (b, a) };
                    let share = (near - outer.w) / (inner.w - outer.w);
                    (inner.vector() + share * (outer.vector() - inner.vector())).into()
                })
            },
        },
        Mistake {
            name: "divided before the cut",
            diagnosis: "You divided x and y by w before you cut. A point behind the eye then lies \
                        on the wrong side of the film. Cut first: x and y stay multiplied by w.",
            answer: |cut| {
                cut.both(|a, b, near| {
                    let (inner, outer) = if a.w >= near { (a, b) } else { (b, a) };
                    let share = (inner.w - near) / (inner.w - outer.w);
                    let (from, to) = (inner.divide(), outer.divide());
                    let place = from + share * (to - from);
                    FilmPoint { x: place.x * near, y: place.y * near, w: near }
                })
            },
        },
        Mistake {
            name: "only w is cut",
            diagnosis: "You moved the outer end to w = near and left its x and y as they were. The \
                        whole point moves along the edge.",
            answer: |cut| {
                cut.both(|a, b, near| {
                    let outer = if a.w >= near { b } else { a };
                    FilmPoint { w: near, ..outer }
                })
            },
        },
    ]
}

/// The formula that many books print.
fn printed(a: FilmPoint, b: FilmPoint, near: f64) -> FilmPoint {
    let share = (near - a.w) / (b.w - a.w);
    (a.vector() + share * (b.vector() - a.vector())).into()
}

/// The same as a mean of both ends.
fn mixed(a: FilmPoint, b: FilmPoint, near: f64) -> FilmPoint {
    let share = (near - a.w) / (b.w - a.w);
    ((1.0 - share) * a.vector() + share * b.vector()).into()
}

/// Of exercise 3.4.
pub(crate) fn draw() -> Vec<Mistake<Draw, Film>> {
    vec![
        Mistake {
            name: "the last one wins",
            diagnosis: "You paint each triangle over what is there. Compare depths first: a sample \
                        keeps the nearest triangle, in whatever order they come.",
            answer: |case| paint(case, 0.5, |_, _, _| (1.0, true)),
        },
        Mistake {
            name: "the last of equals wins",
            diagnosis: "Of two triangles that are equally near, the second replaces the first in \
                        your picture. Replace only what is farther: `>`, not `>=`.",
            answer: |case| {
                paint(case, 0.5, |corners, sample, best| {
                    let inverse = inverse_depth(corners, sample);
                    (inverse, inverse >= best)
                })
            },
        },
        Mistake {
            name: "the farthest one wins",
            diagnosis: "Your depth test points the wrong way. 1/w grows towards the eye: the larger \
                        one is nearer.",
            answer: |case| {
                paint(case, 0.5, |corners, sample, best| {
                    let inverse = inverse_depth(corners, sample);
                    (inverse, best == 0.0 || inverse < best)
                })
            },
        },
        Mistake {
            name: "affine depth",
            diagnosis: "You interpolated w itself on the film. Where two triangles pass through \
                        each other the cut is in the wrong place: interpolate 1/w.",
            answer: |case| {
                paint(case, 0.5, |corners, sample, best| {
                    let inverse = 1.0 / affine_depth(*corners, sample);
                    (inverse, inverse > best)
                })
            },
        },
        Mistake {
            name: "the corner of the pixel",
            diagnosis: "You sample each pixel at its top left corner (x, y). Its centre is at \
                        (x + 0.5, y + 0.5): your picture is half a pixel off.",
            answer: |case| {
                paint(case, 0.0, |corners, sample, best| {
                    let inverse = inverse_depth(corners, sample);
                    (inverse, inverse > best)
                })
            },
        },
        Mistake {
            name: "one order of corners only",
            diagnosis: "Triangles whose corners go the other way round are missing. Turn them: \
                        `edges` does it for you.",
            answer: |case| {
                let clockwise = |number: &usize| {
                    let [a, b, c] = case.triangles[*number].map(FilmPoint::divide);
                    (b - a).perp_dot(c - a) > 0.0
                };
                let numbers: Vec<_> = (0..case.triangles.len()).filter(clockwise).collect();
                let triangles = numbers.iter().map(|&number| case.triangles[number]).collect();
                let case = Draw { triangles, ..*case };
                numbered(&case, 0.5, &numbers, |corners, sample, best| {
                    let inverse = inverse_depth(corners, sample);
                    (inverse, inverse > best)
                })
            },
        },
    ]
}

fn inverse_depth(corners: &[FilmPoint; 3], sample: DVec2) -> f64 {
    Interpolation::new(*corners).map_or(0.0, |functions| functions.inverse_depth(sample))
}

/// A drawing loop with samples at `inset` from the pixel's corner. `test` gives what is kept of a
/// triangle at a sample, and whether it is.
fn paint(case: &Draw, inset: f64, test: fn(&[FilmPoint; 3], DVec2, f64) -> (f64, bool)) -> Film {
    let numbers: Vec<usize> = (0..case.triangles.len()).collect();
    numbered(case, inset, &numbers, test)
}

/// The same for triangles that have these numbers.
fn numbered(
    case: &Draw,
    inset: f64,
    numbers: &[usize],
    test: fn(&[FilmPoint; 3], DVec2, f64) -> (f64, bool),
) -> Film {
    let mut best = vec![0.0; case.width as usize * case.height as usize];
    let mut film = Film::new(case.width, case.height);
    for (corners, &number) in case.triangles.iter().zip(numbers) {
        let snapped = corners.map(|corner| Fixed::snap(corner.divide()));
        let Some(edges) = edges(snapped) else { continue };
        for y in 0..case.height {
            for x in 0..case.width {
                let sample = DVec2::new(f64::from(x), f64::from(y)) + inset;
                let best = &mut best[(y * case.width + x) as usize];
                let (kept, nearer) = test(corners, sample, *best);
                if covers(&edges, Fixed::snap(sample)) && nearer {
                    *best = kept;
                    *film.pixel_mut(x, y) = color_of(number);
                }
            }
        }
    }
    film
}
