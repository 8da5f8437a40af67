//! What readers get wrong about how much goes where.

use common::exercise::Mistake;
use common::film::Color;
use common::stats::estimate::Estimate;
use fresnel::naive::equation_2_2;

use crate::cases::{Pair, Seen, Surface};
use crate::solutions;

/// Both amplitudes, for a cosine beyond that is there.
fn amplitudes(&Surface { near, far, cosine }: &Surface, beyond: f32) -> [f32; 2] {
    [
        (near * cosine - far * beyond) / (near * cosine + far * beyond),
        (far * cosine - near * beyond) / (far * cosine + near * beyond),
    ]
}

fn from_amplitudes(surface: &Surface, part: fn([f32; 2]) -> f32) -> f32 {
    let beyond = solutions::far_cosine(surface);
    beyond.map_or(1.0, |beyond| part(amplitudes(surface, beyond)))
}

pub(crate) fn of_reflectance() -> Vec<Mistake<Surface, f32>> {
    vec![
        Mistake {
            name: "one polarization only",
            diagnosis: "You gave the part of light that swings at right angles to the plane of incidence. \
                Unpolarized light is half of each: take the mean. See 'How much is reflected'.",
            answer: |it| from_amplitudes(it, |[perpendicular, _]| perpendicular * perpendicular),
        },
        Mistake {
            name: "the sum, not the mean",
            diagnosis: "You added both parts. Each holds for half of the light: divide by 2. See \
                'How much is reflected'.",
            answer: |it| from_amplitudes(it, |[one, other]| one * one + other * other),
        },
        Mistake {
            name: "amplitudes are not squared",
            diagnosis: "You averaged amplitudes. Light's power is the square of its amplitude. See \
                'How much is reflected'.",
            answer: |it| from_amplitudes(it, |[one, other]| (one.abs() + other.abs()) / 2.0),
        },
        Mistake {
            name: "the mean before the square",
            diagnosis: "You squared the mean of the amplitudes; take the mean of the squares. See \
                'How much is reflected'.",
            answer: |it| {
                from_amplitudes(it, |[one, other]| ((one + other) / 2.0) * ((one + other) / 2.0))
            },
        },
        Mistake {
            name: "nothing for total reflection",
            diagnosis: "Where no light gets through, all of it is reflected: the part is 1. You gave 0. \
                See 'How much is reflected'.",
            answer: |it| solutions::far_cosine(it).map_or(0.0, |_| solutions::reflectance(it)),
        },
        Mistake {
            name: "as if the ray came straight",
            diagnosis: "You left the angle out: that is what is reflected of a ray along the normal. See \
                'How much is reflected'.",
            answer: |it| solutions::reflectance(&Surface { cosine: 1.0, ..*it }),
        },
    ]
}

/// Schlick's polynomial of any cosine.
fn polynomial(&Surface { near, far, .. }: &Surface, cosine: f32) -> f32 {
    let straight = ((near - far) / (near + far)) * ((near - far) / (near + far));
    straight + (1.0 - straight) * fifth_power(1.0 - cosine)
}

fn fifth_power(x: f32) -> f32 {
    x * x * x * x * x
}

pub(crate) fn of_schlick() -> Vec<Mistake<Surface, f32>> {
    vec![
        Mistake {
            name: "the cosine of this side",
            diagnosis: "You used the angle inside the glass for a ray that leaves it. The larger angle \
                counts, the one in the thinner medium; and beyond the critical angle all is reflected. \
                See 'Schlick's approximation'.",
            answer: |it| polynomial(it, it.cosine),
        },
        Mistake {
            name: "the cosine of this side, but for total reflection",
            diagnosis: "Total reflection you have. But below the critical angle you used the angle \
                inside the glass: the larger one, in the thinner medium, counts. See 'Schlick's \
                approximation'.",
            answer: |it| solutions::far_cosine(it).map_or(1.0, |_| polynomial(it, it.cosine)),
        },
        Mistake {
            name: "the cosine beyond, always",
            diagnosis: "You used the angle beyond the interface both ways. It is the larger one only for \
                a ray that leaves the denser medium. See 'Schlick's approximation'.",
            answer: |it| solutions::far_cosine(it).map_or(1.0, |cosine| polynomial(it, cosine)),
        },
        Mistake {
            name: "1 - R0 is missing",
            diagnosis: "You added the whole fifth power to R0, so that grazing light is reflected more \
                than wholly. What is to be added is (1 - R0) times that. See 'Schlick's approximation'.",
            answer: |it| {
                let straight = polynomial(it, 1.0);
                let cosine = solutions::far_cosine(it).map(|beyond| beyond.min(it.cosine));
                cosine.map_or(1.0, |cosine| straight + fifth_power(1.0 - cosine))
            },
        },
        Mistake {
            name: "R0 is not squared",
            diagnosis: "(n_near - n_far) / (n_near + n_far) is an amplitude; R0 is its square. See \
                'Schlick's approximation'.",
            answer: |it| {
                let straight = polynomial(it, 1.0).sqrt();
                let cosine = solutions::far_cosine(it).map(|beyond| beyond.min(it.cosine));
                cosine.map_or(1.0, |cosine| straight + (1.0 - straight) * fifth_power(1.0 - cosine))
            },
        },
    ]
}

pub(crate) fn of_one_of_two() -> Vec<Mistake<Pair, Estimate>> {
    vec![
        Mistake {
            name: "counted twice",
            diagnosis: "You chose the mirror's ray as often as it counts, and then multiplied it by its \
                part as well. It already counts in full. See 'Two rays, or one'.",
            answer: |pair| {
                pair.estimate(|part, mirrored, refracted, chance| {
                    if chance < part { part * mirrored } else { (1.0 - part) * refracted }
                })
            },
        },
        Mistake {
            name: "the wrong ray as often",
            diagnosis: "You chose the mirror's ray with the probability of the other one. chance < part \
                is true in `part` of all cases. See 'Two rays, or one'.",
            answer: |pair| {
                pair.estimate(
                    |part, mirrored, refracted, chance| {
                        if chance > part { mirrored } else { refracted }
                    },
                )
            },
        },
        Mistake {
            name: "a coin, and nothing put right",
            diagnosis: "You tossed a coin and gave the ray's light, so both rays count half. Divide what \
                a ray counts by the probability of looking at it. See 'Two rays, or one'.",
            answer: |pair| {
                pair.estimate(
                    |_, mirrored, refracted, chance| {
                        if chance < 0.5 { mirrored } else { refracted }
                    },
                )
            },
        },
        Mistake {
            name: "a coin, and half put right",
            diagnosis: "You tossed a coin and weighted the ray by its part, but half of all rays are not \
                looked at: divide by the probability, one half. See 'Two rays, or one'.",
            answer: |pair| {
                pair.estimate(
                    |part, mirrored, refracted, chance| {
                        if chance < 0.5 { part * mirrored } else { (1.0 - part) * refracted }
                    },
                )
            },
        },
    ]
}

pub(crate) fn of_seen() -> Vec<Mistake<Seen, Color>> {
    vec![
        Mistake {
            name: "equation 2-2 as it was published",
            diagnosis: "Both k are constants here: what is reflected of a ray along the normal, and the \
                rest. But it depends on the angle, and beyond the critical angle it is everything. See \
                'How much is reflected'.",
            answer: |seen| {
                let straight = polynomial(&seen.surface, 1.0);
                equation_2_2(Color::ZERO, straight, seen.mirrored, 1.0 - straight, seen.refracted)
            },
        },
        Mistake {
            name: "radiance is not scaled",
            diagnosis: "Your parts are right, but radiance changes by (n_near / n_far)² on its way through \
                the interface: directions are squeezed in the denser medium. See 'Radiance in glass'.",
            answer: |seen| {
                let part = solutions::reflectance(&seen.surface);
                part * seen.mirrored + (1.0 - part) * seen.refracted
            },
        },
        Mistake {
            name: "radiance is scaled the other way",
            diagnosis: "You multiplied by (n_far / n_near)². Radiance is larger in the denser medium, so \
                on its way out of it becomes smaller. See 'Radiance in glass'.",
            answer: |seen| {
                let part = solutions::reflectance(&seen.surface);
                let ratio = seen.surface.far / seen.surface.near;
                part * seen.mirrored + (1.0 - part) * ratio * ratio * seen.refracted
            },
        },
        Mistake {
            name: "the ratio is not squared",
            diagnosis: "You scaled radiance by n_near / n_far. A solid angle is squeezed in both of its \
                directions: square it. See 'Radiance in glass'.",
            answer: |seen| {
                let part = solutions::reflectance(&seen.surface);
                let ratio = seen.surface.near / seen.surface.far;
                part * seen.mirrored + (1.0 - part) * ratio * seen.refracted
            },
        },
        Mistake {
            name: "more than all the light",
            diagnosis: "You reflect a part and let everything through. What is reflected is missing in what \
                goes on: 1 less that part. See 'How much is reflected'.",
            answer: |seen| {
                let part = solutions::reflectance(&seen.surface);
                let ratio = seen.surface.near / seen.surface.far;
                part * seen.mirrored + ratio * ratio * seen.refracted
            },
        },
    ]
}
