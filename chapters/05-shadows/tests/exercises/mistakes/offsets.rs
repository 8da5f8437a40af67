//! Mistakes with where a ray starts: exercise 5.3.

use common::exercise::Mistake;
use shadows::naive;

use crate::cases::Leaving;

/// The distance and the side that a right answer starts from.
fn reach_and_side(case: &Leaving) -> (f32, f32) {
    let reach = case.hit.geometric.abs().dot(case.hit.error);
    (reach, if case.hit.geometric.dot(case.direction) < 0.0 { -1.0 } else { 1.0 })
}

pub(crate) fn of_leave() -> Vec<Mistake<Leaving, f64>> {
    vec![
        Mistake {
            name: "no offset",
            diagnosis: "You start in the point itself, which may be on the wrong side of its \
                        surface: see 'Acne'.",
            answer: |case| case.clearance(case.hit.point),
        },
        Mistake {
            name: "a fixed step",
            diagnosis: "You step a fixed distance off the surface. Whatever it is, there is a scene \
                        so large that rounding swallows it and one so small that it jumps over \
                        things: see 'A number without a unit'.",
            answer: |case| case.clearance(naive::normal(&case.hit, case.direction)),
        },
        Mistake {
            name: "along the ray",
            diagnosis: "You step along the ray. When it runs flat along the surface, that hardly \
                        leaves it: step along the normal. See 'As far as the point may be wrong'.",
            answer: |case| {
                let (reach, _) = reach_and_side(case);
                let offset = reach * case.direction.normalize();
                let away = |axis: usize| step(case.hit.point[axis] + offset[axis], offset[axis]);
                case.clearance([away(0), away(1), away(2)].into())
            },
        },
        Mistake {
            name: "always outwards",
            diagnosis: "You always step to the side the normal points to. A ray that leaves on the \
                        other side has to start there: see 'As far as the point may be wrong'.",
            answer: |case| {
                let offset = reach_and_side(case).0 * case.hit.geometric;
                let away = |axis: usize| step(case.hit.point[axis] + offset[axis], offset[axis]);
                case.clearance([away(0), away(1), away(2)].into())
            },
        },
        Mistake {
            name: "lost in rounding",
            diagnosis: "The sum of the point and the offset is rounded, maybe back to the point \
                        itself. Go a float or two further along each axis that the normal leans \
                        to: see 'As far as the point may be wrong'.",
            answer: |case| {
                let (reach, side) = reach_and_side(case);
                case.clearance(case.hit.point + side * reach * case.hit.geometric)
            },
        },
        Mistake {
            name: "the whole error",
            diagnosis: "You step as far as the error's length. Only its part along the normal can \
                        take the point off the surface, the rest moves it along: sum |n_i| e_i. See \
                        'As far as the point may be wrong'.",
            answer: |case| {
                let (_, side) = reach_and_side(case);
                let offset = side * case.hit.error.length() * case.hit.geometric;
                let away = |axis: usize| step(case.hit.point[axis] + offset[axis], offset[axis]);
                case.clearance([away(0), away(1), away(2)].into())
            },
        },
    ]
}

/// One float further in the direction of `offset`.
fn step(coordinate: f32, offset: f32) -> f32 {
    match offset {
        offset if offset > 0.0 => coordinate.next_up(),
        offset if offset < 0.0 => coordinate.next_down(),
        _ => coordinate,
    }
}
