//! What readers get wrong.

mod meets;

use boxes::aabb::Aabb;
use boxes::naive::of_points;
use common::exercise::Mistake;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::{Padding, Question, solutions};

pub(crate) use meets::meets;

/// Of exercise 8.1.
pub(crate) fn smallest_box() -> Vec<Mistake<Vec<Vec3>, Option<Aabb>>> {
    vec![
        Mistake {
            name: "min and max of NaN",
            diagnosis: "After a NaN you have forgotten the points before it: glam's min and max give \
                        the second of two when one is NaN. Leave the point out. See 'The smallest \
                        box'.",
            answer: |points| filled(of_points(points)),
        },
        Mistake {
            name: "coordinates of bad points",
            diagnosis: "You left out a NaN coordinate, but kept its point's other coordinates, or \
                        infinity. No triangle with such a corner can be hit: leave out the whole \
                        point. See 'The smallest box'.",
            answer: |points| {
                let mut bounds = Aabb::EMPTY;
                for point in points {
                    bounds = bounds.union(Aabb { min: *point, max: *point });
                }
                filled(bounds)
            },
        },
        Mistake {
            name: "from the origin",
            diagnosis: "You started with a box at the origin, so the origin is always in it. Start \
                        with the empty box, whose min is +infinity and max -infinity. See 'The \
                        smallest box'.",
            answer: |points| {
                let origin = Aabb { min: Vec3::ZERO, max: Vec3::ZERO };
                finite(points).next()?;
                Some(finite(points).fold(origin, Aabb::grow))
            },
        },
        Mistake {
            name: "the smallest positive number",
            diagnosis: "You started the maximum with f32::MIN_POSITIVE, which is above 0, so points \
                        below 0 don't count. The smallest number is -infinity. See 'The smallest \
                        box'.",
            answer: |points| {
                let start =
                    Aabb { min: Vec3::splat(f32::MAX), max: Vec3::splat(f32::MIN_POSITIVE) };
                finite(points).next()?;
                Some(finite(points).fold(start, Aabb::grow))
            },
        },
    ]
}

fn finite(points: &[Vec3]) -> impl Iterator<Item = Vec3> {
    points.iter().copied().filter(|point| point.is_finite())
}

fn filled(bounds: Aabb) -> Option<Aabb> {
    (!bounds.is_empty()).then_some(bounds)
}

/// Of exercise 8.2.
pub(crate) fn surface_area() -> Vec<Mistake<Aabb, f32>> {
    vec![
        Mistake {
            name: "edges for faces",
            diagnosis: "You took 2 (x + y + z): that is a length. It happens to be 6 for a cube of \
                        side 1, and so is the area. See 'Large faces are met more often'.",
            answer: |bounds| 2.0 * sides(bounds).element_sum(),
        },
        Mistake {
            name: "a face counted twice",
            diagnosis: "One pair of sides is there twice and another is missing: 2 (xy + yz + xy). A \
                        cube doesn't show it. See 'Large faces are met more often'.",
            answer: |bounds| {
                let Vec3 { x, y, z } = sides(bounds);
                2.0 * (x * y + y * z + x * y)
            },
        },
        Mistake {
            name: "three faces",
            diagnosis: "You added three faces. A box has six: each of the three has its opposite. See \
                        'Large faces are met more often'.",
            answer: |bounds| 0.5 * solutions::surface_area(bounds),
        },
        Mistake {
            name: "an empty box",
            diagnosis: "An empty box has a negative side, or three, and the products of two of them \
                        are positive. Its area is 0. See 'Large faces are met more often'.",
            answer: |bounds| {
                let Vec3 { x, y, z } = bounds.max - bounds.min;
                2.0 * (x * y + y * z + z * x)
            },
        },
        Mistake {
            name: "three faces, and an empty box",
            diagnosis: "Two things. You added three faces, and a box has six: each of the three has \
                        its opposite. And an empty box has a negative side, or three, and the \
                        products of two of them are positive: its area is 0. See 'Large faces are \
                        met more often'.",
            answer: |bounds| {
                let Vec3 { x, y, z } = bounds.max - bounds.min;
                x * y + y * z + z * x
            },
        },
        Mistake {
            name: "volume",
            diagnosis: "You multiplied all three sides: that is the volume, and 0 for a flat box, \
                        which rays can meet. See 'Large faces are met more often'.",
            answer: |bounds| sides(bounds).element_product(),
        },
    ]
}

fn sides(bounds: &Aabb) -> Vec3 {
    bounds.size()
}

/// Of exercise 8.3.
pub(crate) fn enter() -> Vec<Mistake<Question, Option<f32>>> {
    vec![
        Mistake {
            name: "min is always near",
            diagnosis: "You took min for the near face on every axis. A ray that runs downwards meets \
                        max first: swap the two where the direction is negative. See 'Three slabs'.",
            answer: |question| {
                let (a, b) = faces(question);
                between(a.max_element().max(0.0), b.min_element().min(question.t_max))
            },
        },
        Mistake {
            name: "the first near face",
            diagnosis: "You took the nearest of the near faces, and the farthest of the far ones. \
                        The ray is in the box when it is in all three slabs: past the last near \
                        face, and before the first far one. See 'Three slabs'.",
            answer: |question| {
                let (near, far) = sorted(question);
                between(near.min_element().max(0.0), far.max_element().min(question.t_max))
            },
        },
        Mistake {
            name: "behind the origin",
            diagnosis: "You met boxes that lie behind the ray's origin, or gave a distance below 0 \
                        for a ray that starts inside. The interval starts at 0. See 'Three slabs'.",
            answer: |question| {
                let (near, far) = sorted(question);
                between(near.max_element(), far.min_element().min(question.t_max))
            },
        },
        Mistake {
            name: "no t_max",
            diagnosis: "You met a box beyond t_max. What hides it has been found already. See 'Three \
                        slabs'.",
            answer: |question| {
                let (near, far) = sorted(question);
                between(near.max_element().max(0.0), far.min_element())
            },
        },
    ]
}

fn faces(Question { ray, bounds, .. }: &Question) -> (Vec3, Vec3) {
    let Ray { origin, direction } = *ray;
    ((bounds.min - origin) / direction, (bounds.max - origin) / direction)
}

fn sorted(question: &Question) -> (Vec3, Vec3) {
    let (a, b) = faces(question);
    (a.min(b), a.max(b))
}

fn between(enter: f32, leave: f32) -> Option<f32> {
    (enter <= leave).then_some(enter)
}

/// Of exercise 8.5.
pub(crate) fn pad() -> Vec<Mistake<Padding, f32>> {
    vec![
        Mistake {
            name: "0.0001",
            diagnosis: "You padded by a fixed length. In a scene of a millionth of a unit it is larger \
                        than the scene, in one of a million it is nothing. See 'A pad with a unit'.",
            answer: |_| 1e-4,
        },
        Mistake {
            name: "from the origin of coordinates",
            diagnosis: "You measured from the origin of coordinates and not from the ray's. The \
                        roundings come with the differences between corners and the ray's origin. \
                        See 'A pad with a unit'.",
            answer: |Padding { scene, .. }| {
                part(scene.min.abs().max(scene.max.abs()).max_element())
            },
        },
        Mistake {
            name: "the size of the scene",
            diagnosis: "You took the scene's size. A ray may start far away from it, and then its \
                        differences are larger. See 'A pad with a unit'.",
            answer: |Padding { scene, .. }| part(scene.size().max_element()),
        },
        Mistake {
            name: "the nearest corner",
            diagnosis: "You took the nearer of two faces on each axis. The farthest corner has the \
                        largest rounding error. See 'A pad with a unit'.",
            answer: |Padding { origin, scene }| {
                let nearer = (scene.min - origin).abs().min((scene.max - origin).abs());
                part(nearer.max_element())
            },
        },
        Mistake {
            name: "signed distances",
            diagnosis: "You took the largest difference, sign and all, and a corner far below the \
                        origin was not counted. Take absolute values. See 'A pad with a unit'.",
            answer: |Padding { origin, scene }| part((scene.max - origin).max_element()),
        },
    ]
}

fn part(distance: f32) -> f32 {
    8.0 * f32::EPSILON * distance
}
