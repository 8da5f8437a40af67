//! Ways to read equation 2-1: exercise 4.5.

use blinn_phong::exercises::Plain;
use common::exercise::Mistake;
use common::film::Color;
use common::math;
use glam::Vec3;

use crate::cases::Lit;

/// What one lamp adds, from its two cosines.
struct Lamp {
    /// N · L.
    cosine: f32,
    /// N · H.
    half: f32,
    /// R · V.
    mirrored: f32,
    color: Color,
}

/// The ambient term, and for each lamp what `add` makes of it.
fn sum(case: &Lit, add: fn(&Plain, &Lamp) -> Color) -> Color {
    let material = case.material.plain();
    let toward_eye = (case.eye - case.point).normalize();
    let arriving = case.lights.iter().filter_map(|light| light.at(case.point));
    let terms = arriving.map(|arriving| {
        let cosine = case.normal.dot(arriving.toward);
        let mirrored = 2.0 * cosine * case.normal - arriving.toward;
        let half: Vec3 = (toward_eye + arriving.toward).normalize();
        let lamp = Lamp {
            cosine,
            half: case.normal.dot(half),
            mirrored: mirrored.dot(toward_eye),
            color: arriving.color,
        };
        add(&material, &lamp)
    });
    material.ambient + terms.sum::<Color>()
}

/// The clamped power.
fn lobe(cosine: f32, material: &Plain) -> f32 {
    math::pow(cosine.clamp(0.0, 1.0), material.shininess)
}

/// Both terms of a lamp before the surface.
fn before(lamp: &Lamp, material: &Plain, strength: f32) -> Color {
    match lamp.cosine > 0.0 {
        true => lamp.color * (lamp.cosine * material.diffuse + strength * material.specular),
        false => Color::ZERO,
    }
}

pub(crate) fn of_shade() -> Vec<Mistake<Lit, Color>> {
    vec![
        Mistake {
            name: "as published",
            diagnosis: "That is the equation word for word. Behind the surface its cosines are \
                        negative: the first sum takes light away, and the second raises a negative \
                        number to a power that isn't whole, which is no number. See 'Equation 2-1'.",
            answer: |case| {
                sum(case, |material, lamp| {
                    let strength = math::pow(lamp.half, material.shininess);
                    lamp.color * (lamp.cosine * material.diffuse + strength * material.specular)
                })
            },
        },
        Mistake {
            name: "L' taken for L",
            diagnosis: "You took L' for the direction to the lamp, so your highlight sits where the \
                        lamp is straight above and doesn't move with the eye. L' is the half vector \
                        between eye and lamp: see 'Blinn's highlight'.",
            answer: |case| {
                sum(case, |material, lamp| before(lamp, material, lobe(lamp.cosine, material)))
            },
        },
        Mistake {
            name: "L' taken for the mirror",
            diagnosis: "You took L' for the mirrored direction and measured it against the eye: that \
                        is Phong's highlight, and a narrower one. L' is the half vector, measured \
                        against the normal: see 'Blinn's highlight'.",
            answer: |case| {
                sum(case, |material, lamp| before(lamp, material, lobe(lamp.mirrored, material)))
            },
        },
        Mistake {
            name: "a highlight behind the surface",
            diagnosis: "You clamped both cosines, each for itself. The half vector of a lamp behind \
                        the surface can still be before it: there must be no highlight where N · L \
                        is not above 0. See 'Equation 2-1'.",
            answer: |case| {
                sum(case, |material, lamp| {
                    let strength = lobe(lamp.half, material);
                    let cosine = lamp.cosine.max(0.0);
                    lamp.color * (cosine * material.diffuse + strength * material.specular)
                })
            },
        },
        Mistake {
            name: "all lamps are white",
            diagnosis: "You left out what arrives of each lamp, as the printed equation does. Each \
                        term is multiplied by it: see 'Equation 2-1'.",
            answer: |case| {
                sum(case, |material, lamp| {
                    let white = Lamp { color: Color::ONE, ..*lamp };
                    before(&white, material, lobe(lamp.half, material))
                })
            },
        },
        Mistake {
            name: "the cosine twice",
            diagnosis: "You multiplied the highlight by N · L too. That is how it will be done once \
                        surfaces keep their energy, but it is not this equation: see 'Equation 2-1'.",
            answer: |case| {
                sum(case, |material, lamp| {
                    before(lamp, material, lamp.cosine * lobe(lamp.half, material))
                })
            },
        },
    ]
}
