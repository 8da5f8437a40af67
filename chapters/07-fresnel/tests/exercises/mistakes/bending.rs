//! What readers get wrong about directions.

use common::exercise::Mistake;
use glam::Vec3;

use crate::cases::{Bend, Surface};
use crate::solutions;

pub(crate) fn of_far_cosine() -> Vec<Mistake<Surface, Option<f32>>> {
    vec![
        Mistake {
            name: "the ratio is upside down",
            diagnosis: "You used n_far / n_near where Snell's law needs n_near / n_far: the sine is \
                smaller in the denser medium. See 'Bending light'.",
            answer: |it| solutions::far_cosine(&Surface { near: it.far, far: it.near, ..*it }),
        },
        Mistake {
            name: "total reflection is left out",
            diagnosis: "Where the sine beyond would be above 1 no light gets through, and the answer \
                is None. You took the root of 0 instead. See 'Bending light'.",
            answer: |it| Some(solutions::far_cosine(it).unwrap_or(0.0)),
        },
        Mistake {
            name: "a root of a negative number",
            diagnosis: "You took the root before asking whether there is one. It is NaN where light is \
                totally reflected. See 'Bending light'.",
            answer: |it| Some(solutions::far_cosine(it).unwrap_or(f32::NAN)),
        },
        Mistake {
            name: "Snell's law for cosines",
            diagnosis: "You scaled the cosine by n_near / n_far. Snell's law is about sines: go from \
                the cosine to the sine and back. See 'Bending light'.",
            answer: |&Surface { near, far, cosine }| Some((near / far * cosine).min(1.0)),
        },
        Mistake {
            name: "the sine is given",
            diagnosis: "That is the sine beyond; the cosine was asked for. See 'Bending light'.",
            answer: |it| solutions::far_cosine(it).map(|cosine| (1.0 - cosine * cosine).sqrt()),
        },
    ]
}

pub(crate) fn of_refract() -> Vec<Mistake<Bend, Option<Vec3>>> {
    vec![
        Mistake {
            name: "the normal is never turned",
            diagnosis: "For a ray that leaves the body, the normal points to the far side, and its \
                cosine is below 0. Turn it round first. See 'Bending light'.",
            answer: |&Bend { incoming, outward, index }| {
                let ratio = if incoming.dot(outward) < 0.0 { 1.0 / index } else { index };
                bend(incoming, outward, ratio)
            },
        },
        Mistake {
            name: "the ray always enters",
            diagnosis: "You used 1 / index both ways. Out of the body the ratio n_near / n_far is the \
                index itself. See 'Bending light'.",
            answer: |&Bend { incoming, outward, index }| {
                bend(incoming, facing(incoming, outward), 1.0 / index)
            },
        },
        Mistake {
            name: "the ratio is upside down",
            diagnosis: "You used n_far / n_near where Snell's law needs n_near / n_far. Into glass the \
                ray bends towards the normal. See 'Bending light'.",
            answer: |it| solutions::refract(&Bend { index: 1.0 / it.index, ..*it }),
        },
        Mistake {
            name: "total reflection is left out",
            diagnosis: "Where the sine beyond would be above 1 no light gets through. You sent it along \
                the surface instead. See 'Bending light'.",
            answer: |&Bend { incoming, outward, index }| {
                let ratio = if incoming.dot(outward) < 0.0 { 1.0 / index } else { index };
                let normal = facing(incoming, outward);
                let cosine = -incoming.dot(normal);
                let square = (1.0 - ratio * ratio * (1.0 - cosine * cosine)).max(0.0);
                Some(ratio * incoming + (ratio * cosine - square.sqrt()) * normal)
            },
        },
        Mistake {
            name: "a zero vector for total reflection",
            diagnosis: "GAMES101's framework gives the zero vector where nothing gets through, and \
                scales it to length 1 afterwards: that is NaN. Say None. See 'Bending light'.",
            answer: |it| Some(solutions::refract(it).unwrap_or(Vec3::ZERO)),
        },
        Mistake {
            name: "the direction of the mirror",
            diagnosis: "That is what is reflected, and the ray that goes through was asked for. See \
                'Bending light'.",
            answer: |it| Some(it.incoming - 2.0 * it.incoming.dot(it.outward) * it.outward),
        },
    ]
}

fn facing(incoming: Vec3, outward: Vec3) -> Vec3 {
    if incoming.dot(outward) < 0.0 { outward } else { -outward }
}

fn bend(incoming: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = -incoming.dot(normal);
    let square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (square >= 0.0).then(|| ratio * incoming + (ratio * cosine - square.sqrt()) * normal)
}
