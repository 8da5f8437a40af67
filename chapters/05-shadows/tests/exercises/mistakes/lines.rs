//! Mistakes with what is in between: exercises 5.1 and 5.4.

use common::exercise::Mistake;
use common::tally::Off;
use ray_casting::crossing::Crossing;
use ray_casting::ray::Ray;
use ray_casting::shape::nearest;
use shadows::naive;
use shadows::spawn::spawn;

use crate::cases::{Line, Room};

/// Whether no crossing is counted as in the way.
fn clear(line: &Line, blocks: fn(&Crossing) -> bool) -> bool {
    let ray = Ray { origin: line.point, direction: line.lamp - line.point };
    let crossings = line.spheres.iter().filter_map(|sphere| sphere.crossing(&ray));
    !crossings.into_iter().any(|crossing| blocks(&crossing))
}

pub(crate) fn of_sees() -> Vec<Mistake<Line, bool>> {
    vec![
        Mistake {
            name: "a ray without an end",
            diagnosis: "A sphere behind the lamp hides it from you. The way ends at the lamp: only \
                        t below 1 counts, when the direction is lamp - point. See 'A question of \
                        its own'.",
            answer: |line| clear(line, |it| it.first(f32::INFINITY).is_some()),
        },
        Mistake {
            name: "a line without a beginning",
            diagnosis: "A sphere behind the point hides the lamp from you. Only t above 0 is on the \
                        way: see 'A question of its own'.",
            answer: |line| clear(line, |it| it.enter < 1.0),
        },
        Mistake {
            name: "a unit direction, but an end at 1",
            diagnosis: "You scale the direction to length 1 and still end at t = 1, which is then \
                        one unit away and not at the lamp. Leave the direction as long as the way: \
                        see 'A question of its own'.",
            answer: |line| {
                let direction = (line.lamp - line.point).normalize();
                let ray = Ray { origin: line.point, direction };
                let crossings = line.spheres.iter().filter_map(|sphere| sphere.crossing(&ray));
                !crossings.into_iter().any(|crossing| crossing.first(1.0).is_some())
            },
        },
        Mistake {
            name: "the first sphere alone",
            diagnosis: "You ask the first sphere and answer for all. Any of them may be in the way: \
                        see 'A question of its own'.",
            answer: |line| {
                let ray = Ray { origin: line.point, direction: line.lamp - line.point };
                let crossing = line.spheres.first().and_then(|sphere| sphere.crossing(&ray));
                crossing.and_then(|it| it.first(1.0)).is_none()
            },
        },
        Mistake {
            name: "a sphere must be left again",
            diagnosis: "You count a sphere only when the way enters it and leaves it. A lamp inside \
                        a sphere is hidden too: one crossing is enough. See 'A question of its own'.",
            answer: |line| clear(line, |it| 0.0 < it.enter && it.leave < 1.0),
        },
    ]
}

pub(crate) fn of_sees_lamp() -> Vec<Mistake<Room, bool>> {
    vec![
        Mistake {
            name: "the report's line",
            diagnosis: "This is the published line. Its ray starts in the point itself, where the \
                        surface may be in its own way, and its EPSILON has a unit: in a small room \
                        everything is nearer than that, in a large one nothing is. See 'The \
                        report's line'.",
            answer: |room| {
                naive::report_visible(&room.shapes(), room.hit().point, room.lamp(), &mut Off)
            },
        },
        Mistake {
            name: "a relative epsilon in the report's line",
            diagnosis: "Your epsilon grows with the distance, which mends the end of the ray. But \
                        it still starts in the point itself, on this side of its surface or on \
                        that. See 'As far as the point may be wrong'.",
            answer: |room| {
                let (point, lamp) = (room.hit().point, room.lamp());
                let distance = (lamp - point).length();
                let ray = Ray { origin: point, direction: (lamp - point) / distance };
                let shapes = room.shapes();
                let check = nearest(&shapes, &ray, &mut Off).map_or(f32::MAX, |found| found.hit.t);
                check > distance * 0.9999
            },
        },
        Mistake {
            name: "a fixed step off the surface",
            diagnosis: "Your ray starts a fixed step above the surface. In a small room that is \
                        beyond the ball or beyond the lamp; in a large one it is lost in rounding. \
                        See 'A number without a unit'.",
            answer: |room| {
                let (hit, lamp) = (room.hit(), room.lamp());
                let origin = naive::normal(&hit, lamp - hit.point);
                let ray = Ray { origin, direction: lamp - origin };
                !room.shapes().iter().any(|shape| shape.is_hit(&ray, 1.0))
            },
        },
        Mistake {
            name: "a ray without an end",
            diagnosis: "What is behind the lamp hides it from you. With lamp - origin as the \
                        direction, only t below 1 is before the lamp: see 'A question of its own'.",
            answer: |room| {
                let (hit, lamp) = (room.hit(), room.lamp());
                let origin = spawn(&hit, lamp - hit.point);
                let ray = Ray { origin, direction: lamp - origin };
                !room.shapes().iter().any(|shape| shape.is_hit(&ray, f32::INFINITY))
            },
        },
        Mistake {
            name: "an epsilon before the lamp",
            diagnosis: "Your ray starts well and ends a fixed distance before the lamp. That has a \
                        unit, too: in a small scene it is all the way. A point lamp is no surface \
                        that the ray could hit: t below 1 will do. See 'The report's line'.",
            answer: |room| {
                let (hit, lamp) = (room.hit(), room.lamp());
                let origin = spawn(&hit, lamp - hit.point);
                let distance = (lamp - origin).length();
                let ray = Ray { origin, direction: (lamp - origin) / distance };
                !room.shapes().iter().any(|shape| shape.is_hit(&ray, distance - 1e-4))
            },
        },
        Mistake {
            name: "the last twentieth is skipped",
            diagnosis: "You end the ray well before the lamp, so that a ball close to it hides \
                        nothing. A point lamp is no surface that the ray could hit: t below 1 will \
                        do. See 'The report's line'.",
            answer: |room| {
                let (hit, lamp) = (room.hit(), room.lamp());
                let origin = spawn(&hit, lamp - hit.point);
                let ray = Ray { origin, direction: lamp - origin };
                !room.shapes().iter().any(|shape| shape.is_hit(&ray, 0.95))
            },
        },
    ]
}
