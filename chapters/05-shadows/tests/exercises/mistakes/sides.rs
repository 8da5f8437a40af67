//! Mistakes with two normals: exercise 5.5.

use common::exercise::Mistake;
use glam::Vec3;

use crate::cases::Sides;

fn turned(normal: Vec3, toward: Vec3) -> Vec3 {
    if normal.dot(toward) < 0.0 { -normal } else { normal }
}

pub(crate) fn of_arriving_cosine() -> Vec<Mistake<Sides, f32>> {
    vec![
        Mistake {
            name: "the shading normal decides",
            diagnosis: "You ask the leaning normal whether the lamp is above the surface. It says \
                        yes to a lamp below, and light shines through: ask the surface's own. See \
                        'Two normals'.",
            answer: |it| turned(it.shading, turned(it.geometric, it.eye)).dot(it.lamp).max(0.0),
        },
        Mistake {
            name: "the shading normal turned to the eye",
            diagnosis: "You turn the leaning normal by itself to the eye's side. Near the rim it \
                        may point away from the eye though its surface doesn't: turn it to the side \
                        of the surface's own normal. See 'Two normals'.",
            answer: |it| {
                let above = turned(it.geometric, it.eye).dot(it.lamp) > 0.0;
                if above { turned(it.shading, it.eye).dot(it.lamp).max(0.0) } else { 0.0 }
            },
        },
        Mistake {
            name: "one normal for both questions",
            diagnosis: "You ask the leaning normal alone, turned to the eye. It doesn't know on which \
                        side of the surface the eye and the lamp are: the surface's own does. See \
                        'Two normals'.",
            answer: |it| turned(it.shading, it.eye).dot(it.lamp).max(0.0),
        },
        Mistake {
            name: "the surface's own cosine",
            diagnosis: "You give the cosine with the surface's own normal, and a mesh that is to \
                        look smooth shows its facets. That normal says whether light arrives, the \
                        other one how much. See 'Two normals'.",
            answer: |it| turned(it.geometric, it.eye).dot(it.lamp).max(0.0),
        },
        Mistake {
            name: "both sides are lit",
            diagnosis: "You take the cosine without its sign, so that a lamp behind the surface \
                        lights it: see 'Two normals'.",
            answer: |it| it.shading.dot(it.lamp).abs(),
        },
        Mistake {
            name: "a cosine below zero",
            diagnosis: "The lamp is above the surface and below the horizon of the leaning normal: \
                        its cosine is negative there, and light can't be. Take 0. See 'Two normals'.",
            answer: |it| {
                let outward = turned(it.geometric, it.eye);
                let above = outward.dot(it.lamp) > 0.0;
                if above { turned(it.shading, outward).dot(it.lamp) } else { 0.0 }
            },
        },
    ]
}
