//! What readers get wrong about chance.

use common::exercise::Mistake;
use common::math::{cos, sin};
use common::stats::estimate::Estimate;
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

use crate::cases::{Means, Sky, View};
use crate::solutions::on_ball;

pub(crate) fn of_visible_normal() -> Vec<Mistake<View, Means>> {
    vec![
        Mistake {
            name: "all normals",
            diagnosis: "Your normals are spread as D cosθ says, wherever the eye is. Those that are \
                seen lean towards it. See 'Facets that are seen'.",
            answer: |view| view.estimate(all),
        },
        Mistake {
            name: "the view is not pressed",
            diagnosis: "You pressed the normal back, but took the view as it is. Both live where the \
                ellipsoid is a ball: multiply x and y of the view by alpha first. See 'Facets that \
                are seen'.",
            answer: |view| {
                view.estimate(|alpha, outgoing, u| {
                    let normal = on_ball(u.x * (1.0 + outgoing.z), u.y) + outgoing;
                    (normal * Vec3::new(alpha, alpha, 1.0)).normalize()
                })
            },
        },
        Mistake {
            name: "the normal is not pressed back",
            diagnosis: "That is a normal of the ball. For the surface, multiply its x and y by alpha \
                and scale it to length 1. See 'Facets that are seen'.",
            answer: |view| {
                view.estimate(|alpha, outgoing, u| {
                    let view = pressed(alpha, outgoing);
                    (on_ball(u.x * (1.0 + view.z), u.y) + view).normalize()
                })
            },
        },
        Mistake {
            name: "divided by alpha",
            diagnosis: "You divided the ball's normal by alpha. Normals are not stretched as points are: \
                where the ball's surface is drawn out, its slopes grow by alpha. Multiply. See 'Facets \
                that are seen'.",
            answer: |view| {
                view.estimate(|alpha, outgoing, u| {
                    let view = pressed(alpha, outgoing);
                    let normal = on_ball(u.x * (1.0 + view.z), u.y) + view;
                    (normal / Vec3::new(alpha, alpha, 1.0)).normalize()
                })
            },
        },
        Mistake {
            name: "only the upper half of the ball",
            diagnosis: "Rays are reflected down to the height -z of the pressed view, and you took \
                heights from 0 up. See 'Facets that are seen'.",
            answer: |view| {
                view.estimate(|alpha, outgoing, u| {
                    let normal = on_ball(u.x, u.y) + pressed(alpha, outgoing);
                    (normal * Vec3::new(alpha, alpha, 1.0)).normalize()
                })
            },
        },
        Mistake {
            name: "the point of the cap itself",
            diagnosis: "The point of the cap is where the ray is reflected to. The normal is half way \
                between it and the view: add both. See 'Facets that are seen'.",
            answer: |view| {
                view.estimate(|alpha, outgoing, u| {
                    let view = pressed(alpha, outgoing);
                    let point = on_ball(u.x * (1.0 + view.z), u.y);
                    (point * Vec3::new(alpha, alpha, 1.0)).normalize()
                })
            },
        },
    ]
}

fn pressed(alpha: f32, direction: Vec3) -> Vec3 {
    (direction * Vec3::new(alpha, alpha, 1.0)).normalize()
}

fn all(alpha: f32, _outgoing: Vec3, u: Vec2) -> Vec3 {
    let radius = alpha * u.x.sqrt();
    let (x, y) = (cos(TAU * u.y), sin(TAU * u.y));
    Vec3::new(radius * x, radius * y, (1.0 - u.x).sqrt()).normalize()
}

pub(crate) fn of_sent_back() -> Vec<Mistake<Sky, Estimate>> {
    vec![
        Mistake {
            name: "the cosine of the light is left out",
            diagnosis: "Light that grazes the surface is spread over more of it: the cosine of the \
                incoming direction belongs into the integral. See 'The light that is lost'.",
            answer: |sky| sky.estimate(|cosine, u| 1.0 / (cosine + u.x)),
        },
        Mistake {
            name: "the density of the whole sphere",
            diagnosis: "Your mean is twice too large: the upper half of all directions has 2π \
                steradians, not 4π. See 'The light that is lost'.",
            answer: |sky| sky.estimate(|cosine, u| 2.0 * u.x / (cosine + u.x)),
        },
        Mistake {
            name: "masking is left out",
            diagnosis: "You took G₂ as 1, and the surface makes light. Facets are hidden. See \
                'Facets that are hidden'.",
            answer: |sky| sky.estimate(|cosine, _| 0.5 / cosine),
        },
        Mistake {
            name: "the separable masking",
            diagnosis: "You multiplied both G₁. With masking that knows the height it is \
                G₂ = 2 z z' / (z + z'). See 'The light that is lost'.",
            answer: |sky| sky.estimate(|cosine, u| 2.0 * u.x / ((1.0 + cosine) * (1.0 + u.x))),
        },
        Mistake {
            name: "lost samples are drawn again",
            diagnosis: "A facet that sends its light down into the surface has lost it, and counts 0. \
                You drew another one, and count what is left as if it were all. See 'The light that \
                is lost'.",
            answer: |sky| {
                sky.estimate(|cosine, u| {
                    let kept = 0.5 * (1.0 + cosine);
                    u.x / (cosine + u.x) / kept
                })
            },
        },
    ]
}
