//! Mistakes that only a mean can tell: exercises 14.1, 14.2, 14.5 and 14.6.

use common::exercise::Mistake;
use common::film::{Color, Film};
use common::sampler::Stream;
use common::stats::estimate::Estimate;
use russian_roulette::naive::{report, unweighted};

use crate::cases::{ColoredRoom, Light, Room};
use crate::picture::Picture;
use crate::solutions::survival;

pub(crate) fn of_estimate() -> Vec<Mistake<Light, Estimate>> {
    vec![
        Mistake {
            name: "not weighted",
            diagnosis: "You leave light out and never make up for it: what you return stands for all \
                        cases, so divide it by the survival. See 'Equation 4-5'.",
            answer: |light| {
                light.mean(
                    |radiance, survival, chance| {
                        if chance < survival { radiance } else { 0.0 }
                    },
                )
            },
        },
        Mistake {
            name: "the report's line",
            diagnosis: "You return 0 with the probability `survival`, and divide by it. What goes on \
                        has the probability 1 - survival then: turn the comparison round. See 'The \
                        report's line'.",
            answer: |light| {
                light.mean(
                    |radiance, survival, chance| {
                        if chance < survival { 0.0 } else { radiance / survival }
                    },
                )
            },
        },
        Mistake {
            name: "multiplied",
            diagnosis: "You multiply by the survival where you have to divide: what is asked for \
                        seldom must count more. See 'Equation 4-5'.",
            answer: |light| {
                light.mean(
                    |radiance, survival, chance| {
                        if chance < survival { radiance * survival } else { 0.0 }
                    },
                )
            },
        },
    ]
}

/// A path whose throughput is multiplied by `weight` of albedo and survival.
fn walk(weight: f32, survival: f32, chances: &mut Stream) -> f32 {
    let (mut radiance, mut throughput) = (1.0, 1.0);
    while chances.uniform() < survival {
        throughput *= weight;
        radiance += throughput;
    }
    radiance
}

pub(crate) fn of_furnace() -> Vec<Mistake<Room, Estimate>> {
    vec![
        Mistake {
            name: "the survivors don't count more",
            diagnosis: "Paths that go on stand for those that ended. Divide the throughput by the \
                        survival at each surface. See 'Equation 4-5'.",
            answer: |room| room.mean(walk),
        },
        Mistake {
            name: "divided once",
            diagnosis: "You divide by the survival once, at the end. A path that went on k times has the \
                        probability of k decisions: divide at each. See 'A path without a depth'.",
            answer: |room| {
                room.mean(|albedo, survival, chances| {
                    1.0 + (walk(albedo, survival, chances) - 1.0) / survival
                })
            },
        },
        Mistake {
            name: "the report's line in a path",
            diagnosis: "Your path stops as often as it should go on, and goes on as often as it should \
                        stop. Turn the comparison round. See 'The report's line'.",
            answer: |room| {
                room.mean(|albedo, survival, chances| {
                    let (mut radiance, mut throughput) = (1.0, 1.0);
                    while chances.uniform() >= survival {
                        throughput *= albedo / survival;
                        radiance += throughput;
                    }
                    radiance
                })
            },
        },
        Mistake {
            name: "what was gathered is divided too",
            diagnosis: "You divide all that the path has brought so far when it goes on. What it \
                        found before the decision was found in any case: only what comes after it \
                        counts more. See 'A path without a depth'.",
            answer: |room| {
                room.mean(|albedo, survival, chances| {
                    let (mut radiance, mut throughput) = (1.0, 1.0);
                    while chances.uniform() < survival {
                        throughput *= albedo;
                        radiance = (radiance + throughput) / survival;
                    }
                    radiance
                })
            },
        },
        Mistake {
            name: "stops at a depth of 8",
            diagnosis: "Your path ends after eight surfaces, whatever chance says. What comes from further \
                        is lost: let chance alone decide. See 'A path without a depth'.",
            answer: |room| {
                room.mean(|albedo, survival, chances| {
                    let (mut radiance, mut throughput) = (1.0, 1.0);
                    for _ in 0..8 {
                        if chances.uniform() >= survival {
                            break;
                        }
                        throughput *= albedo / survival;
                        radiance += throughput;
                    }
                    radiance
                })
            },
        },
    ]
}

/// A coloured path that goes on as often as `decide` says, and then has its throughput multiplied
/// by `weight` of that.
fn colored(
    room: (Color, f32),
    chances: &mut Stream,
    decide: fn(Color, f32) -> f32,
    weight: fn(f32) -> Color,
) -> Color {
    let (albedo, threshold) = room;
    let (mut radiance, mut throughput) = (Color::ZERO, Color::ONE);
    // Some mistakes would never end.
    for _ in 0..200 {
        radiance += throughput;
        throughput *= albedo;
        let probability = decide(throughput, threshold);
        if chances.uniform() >= probability {
            break;
        }
        throughput *= weight(probability);
    }
    radiance
}

pub(crate) fn of_colored() -> Vec<Mistake<ColoredRoom, [Estimate; 3]>> {
    vec![
        Mistake {
            name: "the survivors don't count more",
            diagnosis: "Paths that go on stand for those that ended. Divide the throughput by the \
                        probability. See 'Equation 4-5'.",
            answer: |room| {
                room.mean(|albedo, threshold, chances| {
                    colored((albedo, threshold), chances, survival, |_| Color::ONE)
                })
            },
        },
        Mistake {
            name: "the darkest colour decides",
            diagnosis: "You take the darkest colour's throughput. Where it is 0 the path ends, with \
                        all light of the other colours on it. Take the brightest. See 'By what a path \
                        carries'.",
            answer: |room| {
                room.mean(|albedo, threshold, chances| {
                    let darkest = |throughput: Color, threshold| {
                        survival(Color::splat(throughput.min_element()), threshold)
                    };
                    colored((albedo, threshold), chances, darkest, |p| Color::splat(1.0 / p))
                })
            },
        },
        Mistake {
            name: "one colour is divided",
            diagnosis: "Only the red part of the throughput counts more when the path goes on. The \
                        decision held for all three: divide all three. See 'By what a path carries'.",
            answer: |room| {
                room.mean(|albedo, threshold, chances| {
                    colored((albedo, threshold), chances, survival, |p| {
                        Color::new(1.0 / p, 1.0, 1.0)
                    })
                })
            },
        },
    ]
}

pub(crate) fn of_go_on() -> Vec<Mistake<Picture, Film>> {
    vec![
        Mistake {
            name: "the report's line as it stands",
            diagnosis: "That is the report's line: it stops with the probability it divides by. Turn \
                        the comparison round. See 'The report's line'.",
            answer: |picture| picture.draw(report),
        },
        Mistake {
            name: "the survivors don't count more",
            diagnosis: "The right paths go on, and they count 1: the light of those that ended is \
                        missing. Divide by the survival. See 'Equation 4-5'.",
            answer: |picture| picture.draw(unweighted),
        },
        Mistake {
            name: "multiplied by the survival",
            diagnosis: "You multiply what goes on by the survival. It has to stand for the paths that \
                        ended as well, and count more: divide. See 'Equation 4-5'.",
            answer: |picture| {
                picture.draw(|survival, chance| (chance < survival).then_some(survival))
            },
        },
        Mistake {
            name: "divided by the probability to stop",
            diagnosis: "You divide by 1 - survival, which is how often paths end. Divide by how often \
                        they go on. See 'The report's line'.",
            answer: |picture| {
                picture.draw(|survival, chance| (chance < survival).then(|| 1.0 / (1.0 - survival)))
            },
        },
    ]
}
