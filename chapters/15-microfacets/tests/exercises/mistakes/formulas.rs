//! What readers get wrong about D, G and densities.

use std::f32::consts::PI;

use common::exercise::Mistake;
use common::math::pow;
use glam::Vec3;
use microfacets::naive;

use crate::cases::{Facet, Pair, Turn};
use crate::solutions;

pub(crate) fn of_density() -> Vec<Mistake<Facet, f32>> {
    vec![
        Mistake {
            name: "digits are lost near the top",
            diagnosis: "You subtract from 1 what is nearly 1. For a small roughness nothing but \
                rounding is left. Use x² + y² in place of 1 - z². See 'How facets lie'.",
            answer: |facet| naive::density(facet.alpha, facet.normal.z),
        },
        Mistake {
            name: "1 - z² in the bracket",
            diagnosis: "1 - z² has lost its digits where z is nearly 1, and they don't come back. Use x² + y² \
                in its place. See 'How facets lie'.",
            answer: |&Facet { alpha, normal }| {
                let (squared, cosine) = (alpha * alpha, normal.z * normal.z);
                let bracket = 1.0 - cosine + squared * cosine;
                squared / (PI * bracket * bracket)
            },
        },
        Mistake {
            name: "the roughness is squared first",
            diagnosis: "You took the roughness's square for alpha, as some programs do with the \
                number an artist gives. Here alpha itself is given. See 'How facets lie'.",
            answer: |&Facet { alpha, normal }| {
                solutions::density(&Facet { alpha: alpha * alpha, normal })
            },
        },
        Mistake {
            name: "π is missing",
            diagnosis: "Your values are π times too large: D cosθ has to integrate to 1. See 'How \
                facets lie'.",
            answer: |facet| PI * solutions::density(facet),
        },
        Mistake {
            name: "the denominator is not squared",
            diagnosis: "x² + y² + α² z² stands in the denominator twice. See 'How facets lie'.",
            answer: |&Facet { alpha, normal }| {
                let across = normal.x * normal.x + normal.y * normal.y;
                alpha * alpha / (PI * (across + alpha * alpha * normal.z * normal.z))
            },
        },
        Mistake {
            name: "cos⁴θ is missing",
            diagnosis: "α² / (π (α² + tan²θ)²) is the density of slopes. For each steradian of \
                normals it has to be divided by cos⁴θ. See 'How facets lie'.",
            answer: |facet| {
                let squared = facet.normal.z * facet.normal.z;
                solutions::density(facet) * squared * squared
            },
        },
    ]
}

pub(crate) fn of_seen_and_lit() -> Vec<Mistake<Pair, f32>> {
    vec![
        Mistake {
            name: "the product of both",
            diagnosis: "That is the separable form, G₁ times G₁: as if being seen and being lit had \
                nothing to do with each other. See 'Facets that are hidden'.",
            answer: |pair| one(pair.alpha, pair.outgoing) * one(pair.alpha, pair.incoming),
        },
        Mistake {
            name: "the smaller of both",
            diagnosis: "The smaller of both G₁ is right only where both directions are the same. See \
                'Facets that are hidden'.",
            answer: |pair| one(pair.alpha, pair.outgoing).min(one(pair.alpha, pair.incoming)),
        },
        Mistake {
            name: "over 4 z z'",
            diagnosis: "You divided by 4 z z' as the whole formula does. Here G₂ alone was asked for: \
                a part of the facets, never above 1. See 'Facets that are hidden'.",
            answer: |pair| {
                solutions::seen_and_lit(pair) / (4.0 * pair.outgoing.z * pair.incoming.z)
            },
        },
        Mistake {
            name: "Λ without its half",
            diagnosis: "Λ is half of √(1 + α² tan²θ) - 1. You took all of it. See 'Facets that are \
                hidden'.",
            answer: |pair| {
                let twice =
                    |direction| solutions::stretch(pair.alpha, direction) / direction.z - 1.0;
                1.0 / (1.0 + twice(pair.outgoing) + twice(pair.incoming))
            },
        },
    ]
}

/// G₁.
fn one(alpha: f32, direction: Vec3) -> f32 {
    2.0 * direction.z / (direction.z + solutions::stretch(alpha, direction))
}

pub(crate) fn of_reflected_density() -> Vec<Mistake<Turn, f32>> {
    vec![
        Mistake {
            name: "the published line",
            diagnosis: "You kept the published line. Turning the normal round the view turns the \
                direction twice as far only where the facet is seen straight; a slanted one sweeps \
                less. See 'From normals to directions'.",
            answer: |turn| naive::reflected_density(turn.density),
        },
        Mistake {
            name: "multiplied by the cosine",
            diagnosis: "The directions are crowded where outgoing · normal is small, so it divides. \
                You multiplied by it. See 'From normals to directions'.",
            answer: |turn| turn.density * turn.outgoing.dot(turn.normal) / 4.0,
        },
        Mistake {
            name: "the normal of the whole surface",
            diagnosis: "You divided by 4 times the cosine at the surface. What turns is the facet: it \
                is outgoing · normal. See 'From normals to directions'.",
            answer: |turn| turn.density / (4.0 * turn.outgoing.z),
        },
        Mistake {
            name: "4 is forgotten",
            diagnosis: "You divided by outgoing · normal alone. The direction turns twice as far as the \
                normal, in two directions at once: divide by 4 too. See 'From normals to directions'.",
            answer: |turn| turn.density / turn.outgoing.dot(turn.normal),
        },
        Mistake {
            name: "2 in place of 4",
            diagnosis: "The direction turns twice as far as the normal, in two directions at once: \
                that is 4. See 'From normals to directions'.",
            answer: |turn| turn.density / (2.0 * turn.outgoing.dot(turn.normal)),
        },
        Mistake {
            name: "the square of the cosine",
            diagnosis: "One of the two sweeps is shortened by outgoing · normal, the other is not. You \
                have its square. See 'From normals to directions'.",
            answer: |turn| turn.density / (4.0 * pow(turn.outgoing.dot(turn.normal), 2.0)),
        },
    ]
}
