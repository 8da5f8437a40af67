//! Mistakes that a picture shows: exercise 6.3.

use common::exercise::Mistake;
use common::film::{Color, Film};
use ray_casting::ray::Ray;
use whitted::exercises::Ball;
use whitted::mirror::leaving;
use whitted::naive::framework_origin;

use crate::balls::Heap;
use crate::solutions::{among, first};

/// The picture of a function that mixes a ball's own light with what its mirror ray brings.
fn mixed(
    balls: &[Ball],
    background: Color,
    ray: &Ray,
    depth: u32,
    mix: fn(&Ball, Color) -> Color,
) -> Color {
    let Some((ball, hit)) = first(balls, ray) else { return background };
    if depth == 0 {
        return ball.light;
    }
    let next = whitted::mirror::mirrored(ray, &hit);
    let rest = next.map(|ray| mixed(balls, background, &ray, depth - 1, mix));
    mix(ball, rest.unwrap_or(Color::ZERO))
}

fn buried(balls: &[Ball], background: Color, ray: &Ray, depth: u32) -> Color {
    let Some((ball, hit)) = first(balls, ray) else { return background };
    let Some(direction) = leaving(ray.direction, &hit).filter(|_| depth > 0) else {
        return ball.light;
    };
    let origin = framework_origin(hit.point, hit.normal, direction, 1e-3);
    ball.light + ball.mirror * buried(balls, background, &Ray { origin, direction }, depth - 1)
}

pub(crate) fn of_among() -> Vec<Mistake<Heap, Film>> {
    vec![
        Mistake {
            name: "adding instead of weighing",
            diagnosis: "You add what the mirror ray brings as it is. The ball returns `mirror` of it: \
                        multiply. See 'A surface's own light, and the mirror's'.",
            answer: |heap| {
                heap.picture(|balls, background, ray, depth| {
                    mixed(balls, background, ray, depth, |ball, rest| ball.light + rest)
                })
            },
        },
        Mistake {
            name: "no light of its own",
            diagnosis: "A ball that mirrors returns what its mirror ray brings, and its own light as \
                        well: add it. See 'A surface's own light, and the mirror's'.",
            answer: |heap| {
                heap.picture(|balls, background, ray, depth| {
                    mixed(balls, background, ray, depth, |ball, rest| ball.mirror * rest)
                })
            },
        },
        Mistake {
            name: "no background in the mirrors",
            diagnosis: "A mirror ray that meets nothing brings the background, as a camera ray does: \
                        your mirrors show black there. See 'A surface's own light, and the mirror's'.",
            answer: |heap| {
                heap.picture(|balls, background, ray, depth| {
                    if first(balls, ray).is_none() {
                        return background;
                    }
                    among(balls, Color::ZERO, ray, depth)
                })
            },
        },
        Mistake {
            name: "one mirror too many",
            diagnosis: "At depth 0 no mirror ray is followed, only the camera's. You follow one more \
                        than `depth`: see 'Where following ends'.",
            answer: |heap| {
                heap.picture(|balls, background, ray, depth| {
                    among(balls, background, ray, depth + 1)
                })
            },
        },
        Mistake {
            name: "the mirror ray starts inside the ball",
            diagnosis: "Your mirror ray starts on the wrong side of the surface and meets the ball that \
                        it left from inside: see 'Where the ray starts'.",
            answer: |heap| heap.picture(buried),
        },
    ]
}
