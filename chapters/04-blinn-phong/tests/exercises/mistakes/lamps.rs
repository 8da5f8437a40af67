//! Mistakes in what arrives of a lamp: exercise 4.3.

use common::exercise::Mistake;
use common::film::Color;
use glam::Vec3;

use crate::cases::Lamp;
use crate::solutions;

pub(crate) fn of_arriving() -> Vec<Mistake<Lamp, Option<(Vec3, Color)>>> {
    vec![
        Mistake {
            name: "squares that vanish",
            diagnosis: "Your direction is lost for a lamp very near the point: the squares in its \
                        length are below the smallest f32, so the length is 0. Scale with \
                        ray_casting::direction::unit. See 'Lamps'.",
            answer: |case| {
                let away = case.position - case.point;
                let color = case.color / (1.0 + away.length_squared());
                (away != Vec3::ZERO).then(|| (away / away.length(), color))
            },
        },
        Mistake {
            name: "no number at the lamp",
            diagnosis: "Where the lamp itself is you divide 0 by 0. There is no direction to it: \
                        answer None. See 'Lamps'.",
            answer: |case| solutions::arriving(case).or(Some((Vec3::NAN, case.color))),
        },
        Mistake {
            name: "dark near the lamp",
            diagnosis: "You answer None within some small distance of the lamp. A distance has a \
                        unit, and no number is small in all of them: None belongs to the lamp's own \
                        place alone. See 'Lamps'.",
            answer: |case| {
                let near = (case.position - case.point).length() < 1e-6;
                solutions::arriving(case).filter(|_| !near)
            },
        },
        Mistake {
            name: "away from the lamp",
            diagnosis: "Your direction leads from the lamp to the point. All directions of this \
                        chapter lead away from the surface. See 'Lamps'.",
            answer: |case| solutions::arriving(case).map(|(toward, color)| (-toward, color)),
        },
        Mistake {
            name: "distance for its square",
            diagnosis: "You divided by 1 + d. The light spreads over a sphere, and its area grows \
                        with the square of the distance. See 'Lamps'.",
            answer: |case| {
                let (toward, _) = solutions::arriving(case)?;
                let distance = (case.position - case.point).dot(toward);
                Some((toward, case.color / (1.0 + distance)))
            },
        },
    ]
}
