//! Mistakes with several lamps: exercise 5.2.

use blinn_phong::light::Arriving;
use common::exercise::Mistake;
use common::film::Color;

use crate::cases::Place;
use crate::solutions::sees;

/// What arrives of each lamp, at which cosine, and whether the lamp is seen.
fn lamps(place: &Place) -> Vec<(Arriving, f32, bool)> {
    let lamp = |arriving: Arriving| {
        let position = place.point + arriving.distance * arriving.toward;
        let seen = sees(&place.spheres, place.point, position);
        (arriving, place.normal.dot(arriving.toward), seen)
    };
    place.lamps().iter().filter_map(|it| it.at(place.point)).map(lamp).collect()
}

fn sum(place: &Place, part: fn(&(Arriving, f32, bool)) -> Color) -> Color {
    place.ambient + lamps(place).iter().map(part).sum::<Color>()
}

pub(crate) fn of_light_at() -> Vec<Mistake<Place, Color>> {
    vec![
        Mistake {
            name: "no shadows",
            diagnosis: "You add the lamps whether they are seen or not. Ask for each whether \
                        something is in the way: see 'Several lamps'.",
            answer: |place| sum(place, |(arriving, cosine, _)| arriving.color * cosine.max(0.0)),
        },
        Mistake {
            name: "one shadow for all",
            diagnosis: "As soon as one lamp is hidden, you give none of the others' light. Each \
                        lamp casts its own shadow: see 'Several lamps'.",
            answer: |place| match lamps(place).iter().all(|(_, _, seen)| *seen) {
                true => sum(place, |(arriving, cosine, _)| arriving.color * cosine.max(0.0)),
                false => place.ambient,
            },
        },
        Mistake {
            name: "light from below",
            diagnosis: "A lamp below the surface takes light away: its cosine is negative. Take 0 \
                        instead. See 'Several lamps'.",
            answer: |place| {
                sum(
                    place,
                    |(arriving, cosine, seen)| {
                        if *seen { arriving.color * cosine } else { Color::ZERO }
                    },
                )
            },
        },
        Mistake {
            name: "shadows hide the ambient light",
            diagnosis: "Where a lamp is hidden you leave the ambient light out. It comes from \
                        everywhere, and nothing hides it: see 'Several lamps'.",
            answer: |place| {
                let hidden = lamps(place).iter().any(|(_, _, seen)| !seen);
                let all =
                    sum(
                        place,
                        |(arriving, cosine, seen)| {
                            if *seen { arriving.color * cosine.max(0.0) } else { Color::ZERO }
                        },
                    );
                if hidden { all - place.ambient } else { all }
            },
        },
    ]
}
