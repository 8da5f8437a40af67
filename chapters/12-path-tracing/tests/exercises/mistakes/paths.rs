//! What readers get wrong about whole paths.

use common::exercise::Mistake;
use common::stats::estimate::Estimate;
use path_tracing::exercises::Tiny;

use crate::cases::{Room, Trip};
use crate::solutions;

pub(crate) fn of_furnace() -> Vec<Mistake<Room, Estimate>> {
    vec![
        Mistake {
            name: "the cosine is forgotten",
            diagnosis: "Each of your weights is the albedo twice on average: f / pdf without the cosine, or \
                with it and the density 1 / 4 pi of the whole sphere. See 'The furnace'.",
            answer: |room| room.estimate(|albedo, depth, _| series(2.0 * albedo, depth)),
        },
        Mistake {
            name: "the density of other directions",
            diagnosis: "You divided by cosine / pi, but your directions are uniform: their density is \
                1 / 2 pi. Or you weighed with albedo times cosine alone. A weight belongs to the \
                density that chose the direction. See 'One path'.",
            answer: |room| room.estimate(|albedo, depth, random| walk(depth, || albedo * random())),
        },
        Mistake {
            name: "one surface too many",
            diagnosis: "The first wall is seen without leaving a surface: a depth of 0 brings 1. You saw \
                one surface more. See 'Where to stop'.",
            answer: |room| {
                room.estimate(|albedo, depth, random| solutions::furnace(albedo, depth + 1, random))
            },
        },
        Mistake {
            name: "one surface too few",
            diagnosis: "A depth of 1 leaves one surface, and sees two that glow. You stopped before that. \
                See 'Where to stop'.",
            answer: |room| {
                room.estimate(|albedo, depth, random| {
                    solutions::furnace(albedo, depth.saturating_sub(1), random)
                })
            },
        },
        Mistake {
            name: "the first wall doesn't glow",
            diagnosis: "You began to add up after the first surface was left. What the eye sees glows by \
                itself too. See 'The loop'.",
            answer: |room| {
                room.estimate(|albedo, depth, random| {
                    solutions::furnace(albedo, depth, random) - 1.0
                })
            },
        },
        Mistake {
            name: "the last light only",
            diagnosis: "You gave what the last surface sends, weighted by the throughput. Every surface on \
                the path glows. See 'The loop'.",
            answer: |room| {
                room.estimate(|albedo, depth, random| {
                    (0..depth).map(|_| 2.0 * albedo * random()).product()
                })
            },
        },
        Mistake {
            name: "no throughput",
            diagnosis: "You weighed each surface's light with its own weight alone. It has to pass every \
                surface on its way to the eye: multiply the weights up. See 'The loop'.",
            answer: |room| {
                room.estimate(|albedo, depth, random| {
                    1.0 + (0..depth).map(|_| 2.0 * albedo * random()).sum::<f32>()
                })
            },
        },
    ]
}

/// 1 + a + a² + … with `depth` + 1 terms.
fn series(factor: f32, depth: u32) -> f32 {
    walk(depth, || factor)
}

/// A path whose surfaces have these weights.
fn walk(depth: u32, mut weight: impl FnMut() -> f32) -> f32 {
    let (mut radiance, mut throughput) = (1.0, 1.0);
    for _ in 0..depth {
        throughput *= weight();
        radiance += throughput;
    }
    radiance
}

pub(crate) fn of_tiny_path() -> Vec<Mistake<Trip, Estimate>> {
    vec![
        Mistake {
            name: "the throughput starts anew",
            diagnosis: "You weighed the lamp with one albedo, however many walls its light passed. Multiply \
                them up. See 'The loop'.",
            answer: |trip| {
                trip.estimate(|tiny, depth, random| {
                    let white = Tiny { albedo: 1.0, ..*tiny };
                    tiny.albedo * solutions::tiny_path(&white, depth, random)
                })
            },
        },
        Mistake {
            name: "the light comes before the wall",
            diagnosis: "You added the light before you weighed it with the wall that sends it on: the last \
                albedo is missing. See 'The loop'.",
            answer: |trip| {
                trip.estimate(|tiny, depth, random| {
                    solutions::tiny_path(tiny, depth, random) / tiny.albedo
                })
            },
        },
        Mistake {
            name: "another number for the sky",
            diagnosis: "You asked with a second random number whether the sky is seen, so only those that \
                missed the lamp were asked: too few. One number decides between lamp, sky and wall. See \
                'The loop'.",
            answer: |trip| {
                trip.estimate(|tiny, depth, random| {
                    let mut throughput = 1.0;
                    for _ in 0..depth {
                        throughput *= tiny.albedo;
                        if random() < tiny.lamp_share {
                            return throughput * tiny.lamp;
                        }
                        if random() < tiny.sky_share {
                            return throughput * tiny.sky;
                        }
                    }
                    0.0
                })
            },
        },
        Mistake {
            name: "the sky is not weighted",
            diagnosis: "The sky's light passes the same walls on its way to the eye as the lamp's. Weigh it \
                with the throughput. See 'The loop'.",
            answer: |trip| {
                trip.estimate(|tiny, depth, random| {
                    let mut throughput = 1.0;
                    for _ in 0..depth {
                        throughput *= tiny.albedo;
                        let chance = random();
                        if chance < tiny.lamp_share {
                            return throughput * tiny.lamp;
                        }
                        if chance < tiny.lamp_share + tiny.sky_share {
                            return tiny.sky;
                        }
                    }
                    0.0
                })
            },
        },
        Mistake {
            name: "no sky",
            diagnosis: "A path that leaves the scene brings the sky's light. You dropped it. See 'The loop'.",
            answer: |trip| {
                trip.estimate(|tiny, depth, random| {
                    solutions::tiny_path(&Tiny { sky: 0.0, ..*tiny }, depth, random)
                })
            },
        },
        Mistake {
            name: "the lamp is divided by its chance",
            diagnosis: "You divided the lamp's light by the probability of meeting it. The density of the \
                direction is in the weight already. See 'One path'.",
            answer: |trip| {
                trip.estimate(|tiny, depth, random| {
                    let lamp = tiny.lamp / tiny.lamp_share.max(1e-3);
                    solutions::tiny_path(&Tiny { lamp, ..*tiny }, depth, random)
                })
            },
        },
        Mistake {
            name: "one surface too few",
            diagnosis: "A depth of 1 leaves one surface and may meet the lamp. You stopped before that. \
                See 'Where to stop'.",
            answer: |trip| {
                trip.estimate(|tiny, depth, random| {
                    solutions::tiny_path(tiny, depth.saturating_sub(1), random)
                })
            },
        },
        Mistake {
            name: "one surface too many",
            diagnosis: "You left one surface more than `depth`. At a depth of 0 no surface is left, and this \
                wall doesn't glow. See 'Where to stop'.",
            answer: |trip| {
                trip.estimate(|tiny, depth, random| solutions::tiny_path(tiny, depth + 1, random))
            },
        },
    ]
}
