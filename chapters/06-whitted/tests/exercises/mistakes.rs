//! What readers get wrong.

mod pictures;
mod rows;

use common::exercise::Mistake;
use glam::Vec3;
use whitted::naive::framework_origin;

use crate::cases::{Start, Turn};

pub(crate) use pictures::of_among;
pub(crate) use rows::{of_along, of_depth_needed, of_total};

pub(crate) fn of_mirror_direction() -> Vec<Mistake<Turn, Vec3>> {
    vec![
        Mistake {
            name: "once the normal's part instead of twice",
            diagnosis: "You took the part along the normal away once: what is left runs along the \
                        mirror. It has to be turned round, so take it away twice: see 'Which way a \
                        mirror sends light'.",
            answer: |turn| turn.incoming - turn.incoming.dot(turn.normal) * turn.normal,
        },
        Mistake {
            name: "added instead of taken away",
            diagnosis: "You added twice the part along the normal. That part points into the mirror, \
                        so it has to be taken away: see 'Which way a mirror sends light'.",
            answer: |turn| turn.incoming + 2.0 * turn.incoming.dot(turn.normal) * turn.normal,
        },
        Mistake {
            name: "the way back to where it came from",
            diagnosis: "You turned the part along the mirror round instead of the part along the \
                        normal. That is the formula for a vector that points away from the mirror, as \
                        chapter 4's direction to the lamp; `incoming` points towards it. See 'Which \
                        way a mirror sends light'.",
            answer: |turn| 2.0 * turn.incoming.dot(turn.normal) * turn.normal - turn.incoming,
        },
        Mistake {
            name: "right from the front only",
            diagnosis: "You made the product with the normal positive, or turned the sign by the side. \
                        The normal stands in the formula twice, so its side doesn't matter: leave the \
                        product as it is. See 'Which way a mirror sends light'.",
            answer: |turn| turn.incoming + 2.0 * turn.incoming.dot(turn.normal).abs() * turn.normal,
        },
    ]
}

pub(crate) fn of_mirror_origin() -> Vec<Mistake<Start, Vec3>> {
    vec![
        Mistake {
            name: "the published line",
            diagnosis: "That is GAMES101's line: it moves the origin to the side that the ray doesn't \
                        go to, and the first thing the ray meets is the mirror it left. See 'Where \
                        the ray starts'.",
            answer: |case| framework_origin(case.point, case.normal, case.direction, case.epsilon),
        },
        Mistake {
            name: "always along the normal",
            diagnosis: "You always moved the origin to the normal's side. A ray inside a mirrored ball \
                        stays inside: look which side the direction is on. See 'Where the ray starts'.",
            answer: |case| case.point + case.epsilon * case.normal,
        },
        Mistake {
            name: "along the ray",
            diagnosis: "You moved the origin along the ray. One that nearly runs along the mirror then \
                        hardly gets away from it: move along the normal. See 'Where the ray starts'.",
            answer: |case| case.point + case.epsilon * case.direction,
        },
        Mistake {
            name: "by the product's size",
            diagnosis: "You multiplied by the product of direction and normal, which has the right sign \
                        and any size: a grazing ray hardly moves. Use its sign alone. See 'Where the \
                        ray starts'.",
            answer: |case| {
                case.point + case.epsilon * case.direction.dot(case.normal) * case.normal
            },
        },
    ]
}
