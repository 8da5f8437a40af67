//! What readers get wrong about densities.

use std::f32::consts::{PI, TAU};

use common::exercise::Mistake;
use common::film::Color;
use common::stats::estimate::Estimate;
use glam::{Vec2, Vec3};
use light_sampling::naive;

use crate::cases::{Ball, Scene, Spot, Weighed};
use crate::solutions;

pub(crate) fn of_density() -> Vec<Mistake<Spot, f32>> {
    vec![
        Mistake {
            name: "multiplied by the squared distance's inverse",
            diagnosis: "You gave the solid angle of the lamp, about, not the density. The density is one \
                over it. See 'From directions to points'.",
            answer: |it| it.area * it.cosine / (it.distance * it.distance),
        },
        Mistake {
            name: "the factor upside down",
            diagnosis: "You multiplied by cosine over distance squared. A piece of the lamp fills that much \
                solid angle of its area, so a density per steradian is divided by it. See 'From directions \
                to points'.",
            answer: |it| it.cosine / (it.distance * it.distance * it.area),
        },
        Mistake {
            name: "still one over the area",
            diagnosis: "You gave the density per area. A direction's density is per steradian: a piece of \
                the lamp is seen as cosine over distance squared of its area. See 'From directions to \
                points'.",
            answer: |it| 1.0 / it.area,
        },
        Mistake {
            name: "the lamp's cosine is missing",
            diagnosis: "You left the angle at the lamp out. A lamp that is turned away looks narrower: its \
                points are denser. See 'From directions to points'.",
            answer: |it| it.distance * it.distance / it.area,
        },
        Mistake {
            name: "the distance is not squared",
            diagnosis: "You took the distance once. What is twice as far looks half as wide and half as \
                high. See 'From directions to points'.",
            answer: |it| it.distance / (it.area * it.cosine),
        },
        Mistake {
            name: "times the cosine",
            diagnosis: "You multiplied by the cosine. A lamp that is turned away looks narrower, so that its \
                points are denser, not less dense: divide. See 'From directions to points'.",
            answer: |it| it.distance * it.distance * it.cosine / it.area,
        },
    ]
}

/// A point of the lamp by its weights, and what one estimate is with its factor.
fn estimated(
    scene: (Vec3, f32, [Vec3; 3], f32),
    weights: [f32; 3],
    factor: fn(lamp_cosine: f32, distance: f32) -> f32,
) -> f32 {
    let (normal, albedo, [a, b, c], radiance) = scene;
    let point = weights[0] * a + weights[1] * b + weights[2] * c;
    let (distance, across) = (point.length(), (b - a).cross(c - a));
    let direction = point / distance;
    let lamp_cosine = -direction.dot(across) / across.length();
    let cosine = direction.dot(normal).max(0.0);
    let area = 0.5 * across.length();
    radiance * albedo / PI * cosine * area * factor(lamp_cosine, distance)
}

fn uniform(u: Vec2) -> [f32; 3] {
    let root = u.x.sqrt();
    [1.0 - root, root * (1.0 - u.y), root * u.y]
}

pub(crate) fn of_direct() -> Vec<Mistake<Scene, Estimate>> {
    vec![
        Mistake {
            name: "multiplied by the squared distance (erratum 2)",
            diagnosis: "You multiplied by the squared distance, as the report does. Farther lamps look \
                smaller: divide by it. See 'From directions to points'.",
            answer: |scene| {
                scene.estimate(|normal, albedo, corners, radiance, u| {
                    estimated(
                        (normal, albedo, corners, radiance),
                        uniform(u),
                        |cosine, distance| cosine.max(0.0) * distance * distance,
                    )
                })
            },
        },
        Mistake {
            name: "both sides shine",
            diagnosis: "You took the size of the cosine at the lamp. Where it is below 0 the lamp's dark \
                side is seen, and nothing comes. See 'A point of the lamp'.",
            answer: |scene| {
                scene.estimate(|normal, albedo, corners, radiance, u| {
                    estimated(
                        (normal, albedo, corners, radiance),
                        uniform(u),
                        |cosine, distance| cosine.abs() / (distance * distance),
                    )
                })
            },
        },
        Mistake {
            name: "below 0 on the dark side",
            diagnosis: "Your estimates are below 0 where the lamp's dark side is seen: its cosine is. \
                Nothing comes from there, not less than nothing. See 'A point of the lamp'.",
            answer: |scene| {
                scene.estimate(|normal, albedo, corners, radiance, u| {
                    estimated(
                        (normal, albedo, corners, radiance),
                        uniform(u),
                        |cosine, distance| cosine / (distance * distance),
                    )
                })
            },
        },
        Mistake {
            name: "the lamp's cosine is missing",
            diagnosis: "You left the angle at the lamp out: a lamp that is turned away looks narrower. See \
                'From directions to points'.",
            answer: |scene| {
                scene.estimate(|normal, albedo, corners, radiance, u| {
                    estimated(
                        (normal, albedo, corners, radiance),
                        uniform(u),
                        |cosine, distance| {
                            if cosine > 0.0 { 1.0 / (distance * distance) } else { 0.0 }
                        },
                    )
                })
            },
        },
        Mistake {
            name: "points are not uniform",
            diagnosis: "Your points are denser near a corner of the lamp: the first number needs a square \
                root. See 'A point of the lamp'.",
            answer: |scene| {
                scene.estimate(|normal, albedo, corners, radiance, u| {
                    let weights = [1.0 - u.x, u.x * (1.0 - u.y), u.x * u.y];
                    estimated((normal, albedo, corners, radiance), weights, |cosine, distance| {
                        cosine.max(0.0) / (distance * distance)
                    })
                })
            },
        },
        Mistake {
            name: "the albedo as it is",
            diagnosis: "You took the albedo for the BRDF. It is spread over the hemisphere: divide it by π. \
                See 'A point of the lamp'.",
            answer: |scene| {
                scene.estimate(|normal, albedo, corners, radiance, u| {
                    PI * solutions::direct(normal, albedo, corners, radiance, u)
                })
            },
        },
        Mistake {
            name: "a parallelogram's area",
            diagnosis: "You took the length of the cross product for the area. That is a parallelogram's; the \
                triangle's is half of it. See 'A point of the lamp'.",
            answer: |scene| {
                scene.estimate(|normal, albedo, corners, radiance, u| {
                    2.0 * solutions::direct(normal, albedo, corners, radiance, u)
                })
            },
        },
        Mistake {
            name: "the density of directions is kept (erratum 3)",
            diagnosis: "You divided by the density of uniform directions. The point was chosen over the \
                lamp's area: its density is one over that. See 'From directions to points'.",
            answer: |scene| {
                scene.estimate(|normal, albedo, corners, radiance, u| {
                    let [a, b, c] = corners;
                    let area = 0.5 * (b - a).cross(c - a).length();
                    TAU / area * solutions::direct(normal, albedo, corners, radiance, u)
                })
            },
        },
    ]
}

pub(crate) fn of_ball_density() -> Vec<Mistake<Ball, f32>> {
    vec![
        Mistake {
            name: "1 - cosine, computed as such",
            diagnosis: "Right on paper. But for a small cap the cosine rounds to 1, and nothing is left of \
                the difference. Write 1 - cosine as sine² / (1 + cosine). See 'A ball's cap'.",
            answer: |it| 1.0 / (TAU * naive::cap_height(it.distance / it.radius)),
        },
        Mistake {
            name: "the solid angle itself",
            diagnosis: "You gave the cap's solid angle. The density is one over it. See 'A ball's cap'.",
            answer: |it| 1.0 / solutions::ball_density(it.distance, it.radius),
        },
        Mistake {
            name: "as if it were a disc",
            diagnosis: "You took the ball for a disc through its centre, π r² / d². From near by more is \
                seen of the directions than that. See 'A ball's cap'.",
            answer: |it| it.distance * it.distance / (PI * it.radius * it.radius),
        },
        Mistake {
            name: "one over the ball's area",
            diagnosis: "You gave the density per area of the whole ball. Half of it and more can't be seen, \
                and a direction's density is per steradian. See 'A ball's cap'.",
            answer: |it| 1.0 / (2.0 * TAU * it.radius * it.radius),
        },
        Mistake {
            name: "the tangent for the sine",
            diagnosis: "You divided the radius by the length of the tangent, not by the distance of the \
                centre: that is the tangent of the cap's angle, not its sine. See 'A ball's cap'.",
            answer: |it| {
                let square = (it.distance - it.radius) * (it.distance + it.radius);
                let tangent = it.radius / square.sqrt();
                if tangent >= 1.0 {
                    return 1.0 / TAU;
                }
                solutions::ball_density(1.0, tangent)
            },
        },
    ]
}

pub(crate) fn of_light() -> Vec<Mistake<Weighed, Color>> {
    vec![
        Mistake {
            name: "the report's line",
            diagnosis: "That is the line itself: it multiplies by the squared distance, and a lamp that is \
                twice as far would be four times as bright. See 'From directions to points'.",
            answer: |it| it.of(naive::published),
        },
        Mistake {
            name: "the report's line, cut at 0",
            diagnosis: "The dark side you have. But the squared distance is still a factor: divide by it. \
                See 'From directions to points'.",
            answer: |it| {
                let lamp_cosine = it.lamp_cosine.max(0.0);
                Weighed { lamp_cosine, ..*it }.of(naive::published)
            },
        },
        Mistake {
            name: "the dark side takes light away",
            diagnosis: "The distance is right. Where the cosine at the lamp is below 0 its dark side is \
                seen: nothing comes. See 'A point of the lamp'.",
            answer: |it| {
                let square = it.distance * it.distance;
                it.of(naive::published) / (square * square)
            },
        },
        Mistake {
            name: "the squared distance is gone",
            diagnosis: "You took the squared distance away altogether. It belongs below the line: what is \
                twice as far looks a quarter as large. See 'From directions to points'.",
            answer: |it| {
                let lamp_cosine = it.lamp_cosine.max(0.0);
                Weighed { lamp_cosine, distance: 1.0, ..*it }.of(naive::published)
            },
        },
        Mistake {
            name: "the distance, not its square",
            diagnosis: "You divided by the distance. What is twice as far looks half as wide and half as \
                high: divide by its square. See 'From directions to points'.",
            answer: |it| {
                let lamp_cosine = it.lamp_cosine.max(0.0);
                Weighed { lamp_cosine, distance: 1.0, ..*it }.of(naive::published) / it.distance
            },
        },
    ]
}
