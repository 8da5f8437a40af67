//! What readers get wrong about one surface.

use std::f32::consts::PI;

use common::exercise::Mistake;
use common::film::Color;
use path_tracing::naive;

use crate::cases::{Depth, Ray, Weight};
use crate::solutions;

pub(crate) fn of_weight() -> Vec<Mistake<Weight, f32>> {
    vec![
        Mistake {
            name: "no pi",
            diagnosis: "A matte surface's BRDF is its reflectance divided by pi, or it would send on more \
                than it gets. See 'The BRDF'.",
            answer: |it| PI * solutions::weight(it),
        },
        Mistake {
            name: "the cosine is forgotten",
            diagnosis: "You gave f / pdf. Light that comes in at an angle is spread over more surface: \
                multiply by the cosine. See 'The rendering equation'.",
            answer: |&Weight { reflectance, cosine, pdf }| {
                if cosine > 0.0 { reflectance / PI / pdf } else { 0.0 }
            },
        },
        Mistake {
            name: "no density",
            diagnosis: "You gave f times the cosine. An estimate divides by the density with which its \
                direction was chosen. See 'One path'.",
            answer: |&Weight { reflectance, cosine, .. }| reflectance / PI * cosine.max(0.0),
        },
        Mistake {
            name: "light from below",
            diagnosis: "A direction below the surface brings nothing; you gave light less than none. \
                See 'The BRDF'.",
            answer: |&Weight { reflectance, cosine, pdf }| {
                if pdf > 0.0 { reflectance / PI * cosine / pdf } else { 0.0 }
            },
        },
        Mistake {
            name: "nothing divided by nothing",
            diagnosis: "In the surface the cosine and the density are both 0, and their quotient is no \
                number. Ask for the cosine first. See 'Where it breaks'.",
            answer: |&Weight { reflectance, cosine, pdf }| {
                if cosine < 0.0 { 0.0 } else { reflectance / PI * cosine / pdf }
            },
        },
        Mistake {
            name: "always the reflectance",
            diagnosis: "The weight is the reflectance where the density is cosine / pi and nowhere else. \
                Here the density is given. See 'One path'.",
            answer: |&Weight { reflectance, cosine, .. }| {
                if cosine > 0.0 { reflectance } else { 0.0 }
            },
        },
    ]
}

pub(crate) fn of_camera_light() -> Vec<Mistake<Ray, Color>> {
    vec![
        Mistake {
            name: "the report's order",
            diagnosis: "You ask thing number met.thing for its light before you ask whether anything was \
                met. Where nothing was, that number is 0, and the sky shines like the first thing, or \
                there is no such thing. See 'The loop'.",
            answer: |Ray { met, things, sky }| naive::camera_light(met, things, *sky),
        },
        Mistake {
            name: "lamps shine on both sides",
            diagnosis: "You asked in the right order, but gave the radiance of a lamp's back. A lamp that \
                glows on one side shows its light where outgoing_z is above 0. See 'The loop'.",
            answer: |Ray { met, things, sky }| {
                if met.happened { things[met.thing].radiance } else { *sky }
            },
        },
        Mistake {
            name: "no sky",
            diagnosis: "A ray that meets nothing brings the sky's light, and you gave black. See 'The loop'.",
            answer: |it| if it.met.happened { solutions::camera_light(it) } else { Color::ZERO },
        },
        Mistake {
            name: "the sky behind dark things",
            diagnosis: "Where a thing that doesn't glow was met, the sky is hidden. You gave its light. See \
                'The loop'.",
            answer: |it| {
                let light = solutions::camera_light(it);
                if light == Color::ZERO { it.sky } else { light }
            },
        },
    ]
}

pub(crate) fn of_depth() -> Vec<Mistake<Depth, u32>> {
    vec![
        Mistake {
            name: "one too many",
            diagnosis: "At depth d the light of d + 1 surfaces is seen, the first included, and the part \
                that is missing is albedo^(d + 1). You counted d of them. See 'Where to stop'.",
            answer: |it| solutions::depth(it) + 1,
        },
        Mistake {
            name: "the logarithm, rounded up",
            diagnosis: "ln(missing) / ln(albedo), rounded up, is the power of the albedo that is small \
                enough. That power is d + 1 and not d: take 1 off. See 'Where to stop'.",
            answer: |it| if it.albedo == 0.0 { 0 } else { solutions::depth(it) + 1 },
        },
        Mistake {
            name: "one too few",
            diagnosis: "At your depth more than `missing` is left out: the part is albedo^(d + 1). You \
                may have rounded the power down. See 'Where to stop'.",
            answer: |it| solutions::depth(it).saturating_sub(1),
        },
        Mistake {
            name: "an amount and not a part",
            diagnosis: "You bounded the missing radiance, albedo^(d + 1) / (1 - albedo). Asked for is its \
                part of the whole, 1 / (1 - albedo): the quotient is albedo^(d + 1). See 'Where to stop'.",
            answer: |&Depth { albedo, missing }| {
                solutions::depth(&Depth { albedo, missing: missing * (1.0 - albedo) })
            },
        },
        Mistake {
            name: "the next surface's share",
            diagnosis: "You stopped where the next surface would add at most `missing` of the whole, but all \
                that come after it are missing too. See 'Where to stop'.",
            answer: |&Depth { albedo, missing }| {
                if albedo == 0.0 {
                    return 0;
                }
                solutions::depth(&Depth { albedo, missing: missing / (1.0 - albedo) })
            },
        },
    ]
}
