//! Mistakes in what a surface returns: exercises 4.1, 4.2 and 4.4.

use std::f32::consts::PI;

use common::exercise::Mistake;
use common::film::Color;
use common::math;
use glam::Vec3;

use crate::cases::{COLORS, Matte, Place, Shiny};
use crate::solutions;

fn cosine(case: &Matte) -> f32 {
    case.normal.dot(case.toward_light)
}

pub(crate) fn of_lambert() -> Vec<Mistake<Matte, Color>> {
    vec![
        Mistake {
            name: "negative light",
            diagnosis: "A lamp behind the surface takes light away in your code, because the cosine \
                        is negative there. It should give nothing: clamp the cosine at 0. See \
                        'Lambert's law'.",
            answer: |case| cosine(case) * case.color * case.diffuse,
        },
        Mistake {
            name: "lit from behind",
            diagnosis: "You took the cosine's absolute value, so a lamp behind the surface shines \
                        through it. Clamp it at 0 instead: see 'Lambert's law'.",
            answer: |case| cosine(case).abs() * case.color * case.diffuse,
        },
        Mistake {
            name: "no cosine",
            diagnosis: "Your surface returns the same however the lamp stands. A slanted one catches \
                        less of the light, by the cosine between normal and lamp: see 'Lambert's \
                        law'.",
            answer: |case| {
                let lit = if cosine(case) > 0.0 { 1.0 } else { 0.0 };
                lit * case.color * case.diffuse
            },
        },
        Mistake {
            name: "the lamp is white",
            diagnosis: "You left out the colour that arrives. It is multiplied by k_d, channel by \
                        channel: see 'Lambert's law'.",
            answer: |case| cosine(case).max(0.0) * case.diffuse,
        },
        Mistake {
            name: "divided by π",
            diagnosis: "You divided by π, as one does with radiance. In this chapter's unit a white \
                        surface that faces the lamp returns what arrives: see 'Lambert's law'.",
            answer: |case| solutions::lambert(case) / PI,
        },
    ]
}

/// Both highlights from their cosines.
fn powers(case: &Shiny, phong: f32, blinn: f32) -> [f32; 2] {
    [phong, blinn].map(|cosine| math::pow(cosine.clamp(0.0, 1.0), case.shininess as f32))
}

fn mirrored(case: &Shiny) -> Vec3 {
    2.0 * case.normal.dot(case.toward_light) * case.normal - case.toward_light
}

fn blinn(case: &Shiny) -> f32 {
    case.normal.dot((case.toward_eye + case.toward_light).normalize())
}

pub(crate) fn of_highlights() -> Vec<Mistake<Shiny, [f32; 2]>> {
    vec![
        Mistake {
            name: "the half vector is too long",
            diagnosis: "You took eye + lamp for the half vector as it is. It is up to 2 long; only \
                        its direction counts, so scale it to length 1: see 'Blinn's highlight'.",
            answer: |case| {
                let half = case.toward_eye + case.toward_light;
                powers(case, mirrored(case).dot(case.toward_eye), case.normal.dot(half))
            },
        },
        Mistake {
            name: "the mirror points the wrong way",
            diagnosis: "Your mirrored direction runs into the surface. Vec3::reflect expects a \
                        direction that arrives, and the one to the lamp leaves: turn its sign. See \
                        'Phong's highlight'.",
            answer: |case| powers(case, (-mirrored(case)).dot(case.toward_eye), blinn(case)),
        },
        Mistake {
            name: "mirrored half way",
            diagnosis: "You mirrored with N (N · L) - L, which ends on the normal's foot. The mirror \
                        goes as far again to the other side: 2 N (N · L) - L. See 'Phong's \
                        highlight'.",
            answer: |case| {
                let halfway = case.normal.dot(case.toward_light) * case.normal - case.toward_light;
                powers(case, halfway.dot(case.toward_eye), blinn(case))
            },
        },
        Mistake {
            name: "the wrong way round",
            diagnosis: "Your two answers are exchanged: Phong's comes first.",
            answer: |case| powers(case, blinn(case), mirrored(case).dot(case.toward_eye)),
        },
        Mistake {
            name: "no clamp",
            diagnosis: "The mirror may be more than 90 degrees from the eye. Your cosine is negative \
                        there, and so is its power if the exponent is odd: clamp it at 0. See \
                        'Phong's highlight'.",
            answer: |case| {
                let cosines = [mirrored(case).dot(case.toward_eye), blinn(case)];
                cosines.map(|cosine| math::pow(cosine, case.shininess as f32))
            },
        },
        Mistake {
            name: "times n",
            diagnosis: "You multiplied the cosine by n. The cosine is raised to the power n: see \
                        'Phong's highlight'.",
            answer: |case| {
                let cosines = [mirrored(case).dot(case.toward_eye), blinn(case)];
                cosines.map(|cosine| cosine.max(0.0) * case.shininess as f32)
            },
        },
    ]
}

fn stripe(case: &Place) -> usize {
    (case.uv().x * case.count as f32) as usize
}

pub(crate) fn of_stripes() -> Vec<Mistake<Place, Color>> {
    vec![
        Mistake {
            name: "a stripe too many",
            diagnosis: "At u = 1 your stripe has the number `count`, and there is none: its line \
                        belongs to the last stripe. See 'Paint'.",
            answer: |case| COLORS[stripe(case) % 2],
        },
        Mistake {
            name: "twice as many",
            diagnosis: "Your stripes are half as wide as they should be: each of `count` parts holds \
                        both colours. That is how the report's framework writes its checkerboard. \
                        See 'Paint'.",
            answer: |case| {
                let stripe = (case.uv().x * 2.0 * case.count as f32) as u32;
                COLORS[stripe.min(2 * case.count - 1) as usize % 2]
            },
        },
        Mistake {
            name: "across",
            diagnosis: "Your colours change with v. The stripes lie beside each other along u.",
            answer: |case| {
                let stripe = (case.uv().y * case.count as f32) as u32;
                COLORS[stripe.min(case.count - 1) as usize % 2]
            },
        },
        Mistake {
            name: "the other colour first",
            diagnosis: "Your first stripe, where u is 0, has the second colour.",
            answer: |case| COLORS[(stripe(case).min(case.count as usize - 1) + 1) % 2],
        },
    ]
}
