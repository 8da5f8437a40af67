//! What readers get wrong about points, directions and their densities.

use std::f32::consts::{PI, TAU};

use common::exercise::Mistake;
use common::math::{cos, sin};
use common::stats::estimate::Estimate;
use glam::{Vec2, Vec3};

use crate::cases::{Feature, Patch, Sky};
use crate::solutions;

fn polar(radius: f32, angle: f32) -> Vec2 {
    radius * Vec2::new(cos(angle), sin(angle))
}

pub(crate) fn of_disk() -> Vec<Mistake<Feature, Estimate>> {
    vec![
        Mistake {
            name: "the radius is uniform",
            diagnosis: "Your radius is u itself, so that half of the points lie within half the radius, \
                in a quarter of the area. A ring's length grows with its radius: take the root. See \
                'Warps'.",
            answer: |feature| feature.estimate(|u| polar(u.x, TAU * u.y)),
        },
        Mistake {
            name: "half a turn",
            diagnosis: "Your angle goes from 0 to π. A full turn is 2π radians. See 'Warps'.",
            answer: |feature| feature.estimate(|u| polar(u.x.sqrt(), PI * u.y)),
        },
        Mistake {
            name: "the square around the disk",
            diagnosis: "You stretched the square to (-1, 1) both ways. Its corners are outside of the \
                disk. See 'Warps'.",
            answer: |feature| feature.estimate(|u| 2.0 * u - 1.0),
        },
        Mistake {
            name: "the square, pulled in",
            diagnosis: "You moved what lies outside of the disk to its rim. Points must be equally dense \
                everywhere, and there are too many at the rim now. See 'Warps'.",
            answer: |feature| feature.estimate(|u| (2.0 * u - 1.0).clamp_length_max(1.0)),
        },
        Mistake {
            name: "the radius is squared",
            diagnosis: "Your radius is u², which gathers points in the middle. The part within r is r², \
                so r is the root of that part. See 'Warps'.",
            answer: |feature| feature.estimate(|u| polar(u.x * u.x, TAU * u.y)),
        },
    ]
}

fn by_cosine(u: Vec2) -> Vec3 {
    let point = solutions::disk(u);
    point.extend((1.0 - point.length_squared()).max(0.0).sqrt())
}

fn uniform(u: Vec2) -> Vec3 {
    polar((1.0 - u.x * u.x).sqrt(), TAU * u.y).extend(u.x)
}

pub(crate) fn of_irradiance() -> Vec<Mistake<Sky, Estimate>> {
    vec![
        Mistake {
            name: "no cosine",
            diagnosis: "You divided radiance by the uniform density and left out the cosine: a floor gets \
                less from light that grazes it. See 'Choose where to look'.",
            answer: |sky| sky.estimate(|u, radiance| TAU * radiance(uniform(u))),
        },
        Mistake {
            name: "not divided by the density",
            diagnosis: "You gave radiance times cosine. A mean of that is the integral only if the density \
                is 1; divide by it. See 'An integral is a mean'.",
            answer: |sky| sky.estimate(|u, radiance| radiance(uniform(u)) * u.x),
        },
        Mistake {
            name: "the cosine twice",
            diagnosis: "Your directions are as dense as their cosine, and you multiplied by it as well, as if \
                they were uniform. It cancels. See 'Choose where to look'.",
            answer: |sky| sky.estimate(|u, radiance| PI * radiance(by_cosine(u)) * by_cosine(u).z),
        },
        Mistake {
            name: "sampled by one density, divided by another",
            diagnosis: "Your directions are as dense as their cosine, but you divided by 1/(2π), the density \
                of uniform ones. More samples don't mend that. See 'How to tell that it is wrong'.",
            answer: |sky| sky.estimate(|u, radiance| TAU * radiance(by_cosine(u)) * by_cosine(u).z),
        },
        Mistake {
            name: "the whole sphere",
            diagnosis: "You multiplied by 4π, but the directions are those of half a sphere. See 'Choose \
                where to look'.",
            answer: |sky| sky.estimate(|u, radiance| 2.0 * TAU * radiance(uniform(u)) * u.x),
        },
        Mistake {
            name: "uniform angles",
            diagnosis: "You chose both angles uniformly: directions crowd around the normal, where circles \
                are small. It is the height that is uniform. See 'Warps'.",
            answer: |sky| {
                sky.estimate(|u, radiance| {
                    let angle = u.x * PI / 2.0;
                    let direction = polar(sin(angle), TAU * u.y).extend(cos(angle));
                    TAU * radiance(direction) * direction.z
                })
            },
        },
    ]
}

fn area([a, b, c]: [Vec3; 3]) -> f32 {
    (b - a).cross(c - a).length() / 2.0
}

fn at([a, b, c]: [Vec3; 3], second: f32, third: f32) -> Vec3 {
    a + second * (b - a) + third * (c - a)
}

pub(crate) fn of_over_triangle() -> Vec<Mistake<Patch, Estimate>> {
    vec![
        Mistake {
            name: "the parallelogram's area",
            diagnosis: "The length of the cross product is the area of a parallelogram. A triangle is half of \
                it. See 'Warps'.",
            answer: |patch| {
                patch
                    .estimate(|corners, u, value| 2.0 * solutions::over_triangle(corners, u, value))
            },
        },
        Mistake {
            name: "no root",
            diagnosis: "You took u itself for the place along the height. Near the corner the triangle is \
                narrow, so its points are too dense there: take the root. See 'Warps'.",
            answer: |patch| {
                patch.estimate(|corners, u, value| {
                    area(corners) * value(at(corners, u.x * (1.0 - u.y), u.x * u.y))
                })
            },
        },
        Mistake {
            name: "the parallelogram's points",
            diagnosis: "Half of your points lie beyond the side opposite the first corner. The weights of the \
                corners must add up to 1 with none below 0. See 'Warps'.",
            answer: |patch| {
                patch.estimate(|corners, u, value| area(corners) * value(at(corners, u.x, u.y)))
            },
        },
        Mistake {
            name: "divided by the area",
            diagnosis: "You divided by the area. The density is 1 over the area, and it is the density that you \
                divide by. See 'An integral is a mean'.",
            answer: |patch| {
                patch.estimate(|corners, u, value| {
                    let whole = solutions::over_triangle(corners, u, value);
                    whole / (area(corners) * area(corners))
                })
            },
        },
        Mistake {
            name: "the mean, not the integral",
            diagnosis: "Your mean is that of the value over the triangle. The integral is that times the area. \
                See 'An integral is a mean'.",
            answer: |patch| {
                patch.estimate(|corners, u, value| {
                    solutions::over_triangle(corners, u, value) / area(corners)
                })
            },
        },
        Mistake {
            name: "three numbers, scaled to 1",
            diagnosis: "You made weights of random numbers by dividing them by their sum. They add up to 1, but \
                the points crowd in the middle. See 'Warps'.",
            answer: |patch| {
                patch.estimate(|corners, u, value| {
                    let third = (u.x * 7.31 + u.y * 13.57).fract();
                    let sum = (u.x + u.y + third).max(1e-9);
                    area(corners) * value(at(corners, u.y / sum, third / sum))
                })
            },
        },
    ]
}
