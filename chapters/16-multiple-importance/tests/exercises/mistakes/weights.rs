//! What people get wrong about weights.

use common::exercise::Mistake;
use multiple_importance::naive;

use crate::cases::{Arrival, Pair, Point};
use crate::solutions;

pub(crate) fn of_power() -> Vec<Mistake<Pair, f32>> {
    vec![
        Mistake {
            name: "squares first",
            diagnosis: "Above 1.8e19 the square of a density is infinite, and infinity over infinity \
                is no number; below 1e-23 it is 0 over 0. Divide first, then square. See 'Squares that \
                are no numbers'.",
            answer: |&Pair { own, other }| naive::power(own, other),
        },
        Mistake {
            name: "a ratio of squares",
            diagnosis: "You squared both densities before you divided, and squares leave the range of an \
                f32. Divide first, then square. See 'Squares that are no numbers'.",
            answer: |&Pair { own, other }| 1.0 / (1.0 + (other * other) / (own * own)),
        },
        Mistake {
            name: "an infinite square weighs 1",
            diagnosis: "Where both squares are infinite, both strategies count in full, and the light \
                counts twice. Divide first, then square. See 'Squares that are no numbers'.",
            answer: |&Pair { own, other }| naive::infinite_is_one(own, other),
        },
        Mistake {
            name: "0 over 0",
            diagnosis: "Where your own density is 0 you divided by it. What a strategy never finds is \
                none of its own: say 0 first. See 'Squares that are no numbers'.",
            answer: |&Pair { own, other }| {
                let ratio = other / own;
                1.0 / (1.0 + ratio * ratio)
            },
        },
        Mistake {
            name: "the balance heuristic",
            diagnosis: "You shared by the densities themselves; the power heuristic takes their squares. \
                See 'Squares that are no numbers'.",
            answer: |&Pair { own, other }| if own > 0.0 { 1.0 / (1.0 + other / own) } else { 0.0 },
        },
        Mistake {
            name: "the other one's share",
            diagnosis: "That is the share of the other strategy: the ratio is upside down. The larger \
                your own density, the more counts. See 'Shares that add up to one'.",
            answer: |&Pair { own, other }| solutions::power(&Pair { own: other, other: own }),
        },
    ]
}

pub(crate) fn of_share() -> Vec<Mistake<Arrival, f32>> {
    vec![
        Mistake {
            name: "the flag is not asked",
            diagnosis: "From a mirror and from the eye there was only one direction, and `pdf` is no \
                density there. All of the light counts. See 'The path tracer'.",
            answer: |it| it.departure.pdf / (it.departure.pdf + it.light_pdf),
        },
        Mistake {
            name: "nothing, as in chapter 13",
            diagnosis: "You left all that could be looked for to the lamp's samples. They count only a \
                part of it now; the rest has to be found here. See 'The path tracer'.",
            answer: |it| {
                let alone = it.departure.is_delta || it.light_pdf == 0.0;
                if alone { 1.0 } else { 0.0 }
            },
        },
        Mistake {
            name: "the other one's share",
            diagnosis: "That is what the sample of the lamp counts. The path came upon the lamp by \
                `departure.pdf`: that is the strategy whose share is asked for. See 'The path tracer'.",
            answer: |it| {
                let other = it.light_pdf / (it.departure.pdf + it.light_pdf);
                if it.departure.is_delta { 1.0 } else { other }
            },
        },
        Mistake {
            name: "all of it",
            diagnosis: "The light counts in full here, and in part where it was looked for: that is more \
                than all. See 'Shares that add up to one'.",
            answer: |_| 1.0,
        },
        Mistake {
            name: "the power heuristic",
            diagnosis: "You squared the densities; the balance heuristic was asked for. See 'Shares that \
                add up to one'.",
            answer: |it| {
                let pair = Pair { own: it.departure.pdf, other: it.light_pdf };
                if it.departure.is_delta { 1.0 } else { solutions::power(&pair) }
            },
        },
    ]
}

pub(crate) fn of_weight_by_area() -> Vec<Mistake<Point, f32>> {
    vec![
        Mistake {
            name: "the published line",
            diagnosis: "One over an area and one over a solid angle can't be added. Turn the lamp's \
                density into one per steradian first. See 'Apples and steradians'.",
            answer: |it| naive::weight_by_area(it.area, it.by_direction),
        },
        Mistake {
            name: "divided by the squared distance",
            diagnosis: "A lamp that is farther off is seen in a smaller solid angle, so its density per \
                steradian is larger: multiply by the squared distance. See 'Apples and steradians'.",
            answer: |it| by_light(it, it.cosine / (it.area * it.distance * it.distance)),
        },
        Mistake {
            name: "the cosine is above the line",
            diagnosis: "A lamp that is turned away is seen in a smaller solid angle, so its density per \
                steradian is larger: divide by the cosine. See 'Apples and steradians'.",
            answer: |it| by_light(it, it.distance * it.distance * it.cosine / it.area),
        },
        Mistake {
            name: "the cosine is left out",
            diagnosis: "The squared distance is right, and the angle at the lamp is missing: dω = dA cos \
                / distance². See 'Apples and steradians'.",
            answer: |it| by_light(it, it.distance * it.distance / it.area),
        },
        Mistake {
            name: "the distance is not squared",
            diagnosis: "At twice the distance a lamp is half as wide and half as high. See 'Apples and \
                steradians'.",
            answer: |it| by_light(it, it.distance / (it.area * it.cosine)),
        },
        Mistake {
            name: "the other one's share",
            diagnosis: "That is the share of the surface's own direction. See 'Shares that add up to \
                one'.",
            answer: |it| 1.0 - solutions::weight_by_area(it),
        },
    ]
}

fn by_light(it: &Point, density: f32) -> f32 {
    density / (density + it.by_direction)
}
