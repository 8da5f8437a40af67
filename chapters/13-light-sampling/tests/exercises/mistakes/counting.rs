//! What readers get wrong about which lamp is looked at, and how often its light counts.

use common::exercise::Mistake;
use common::stats::estimate::Estimate;

use crate::cases::{Arrival, Many};

/// The lamp in whose part of the power the number lies.
fn picked(powers: &[f32], chance: f32) -> usize {
    let mut rest = chance * powers.iter().sum::<f32>();
    let mut place = 0;
    while place + 1 < powers.len() && rest >= powers[place] {
        rest -= powers[place];
        place += 1;
    }
    place
}

fn uniformly(powers: &[f32], chance: f32) -> usize {
    ((chance * powers.len() as f32) as usize).min(powers.len() - 1)
}

fn total(powers: &[f32]) -> f32 {
    powers.iter().sum()
}

pub(crate) fn of_one_lamp() -> Vec<Mistake<Many, Estimate>> {
    vec![
        Mistake {
            name: "not divided by the probability",
            diagnosis: "You gave the light of the lamp you chose as it is. The mean of that is a mean over \
                lamps, not their sum: divide by the probability of choosing it. See 'One of many lamps'.",
            answer: |many| many.estimate(|powers, lights, chance| lights[picked(powers, chance)]),
        },
        Mistake {
            name: "times the number of lamps",
            diagnosis: "You chose by power, and multiplied by the number of lamps. That is one over the \
                probability only where all are chosen alike. See 'One of many lamps'.",
            answer: |many| {
                many.estimate(|powers, lights, chance| {
                    powers.len() as f32 * lights[picked(powers, chance)]
                })
            },
        },
        Mistake {
            name: "chosen alike, divided by power",
            diagnosis: "You chose all lamps alike, and divided by the probability that power would give \
                them. Divide by the probability with which you really choose. See 'One of many lamps'.",
            answer: |many| {
                many.estimate(|powers, lights, chance| {
                    let place = uniformly(powers, chance);
                    if powers[place] == 0.0 {
                        return 0.0;
                    }
                    lights[place] * total(powers) / powers[place]
                })
            },
        },
        Mistake {
            name: "a lamp without power is chosen",
            diagnosis: "Where the number is 0 and the first lamp has no power, you choose that lamp, and \
                divide by 0. A lamp is chosen where the number lies *below* its end: use <, not <=. See \
                'One of many lamps'.",
            answer: |many| {
                many.estimate(|powers, lights, chance| {
                    let place = if chance > 0.0 { picked(powers, chance) } else { 0 };
                    lights[place] * total(powers) / powers[place]
                })
            },
        },
        Mistake {
            name: "always the brightest",
            diagnosis: "You looked at the brightest lamp each time. The others bring light too: each must \
                have a chance. See 'One of many lamps'.",
            answer: |many| {
                many.estimate(|powers, lights, _| {
                    let brightest = powers.iter().copied().fold(0.0, f32::max);
                    let place = powers.iter().position(|power| *power == brightest).unwrap_or(0);
                    lights[place] * total(powers) / powers[place]
                })
            },
        },
        Mistake {
            name: "times the probability",
            diagnosis: "You multiplied by the probability of the lamp. What is chosen seldom has to count \
                for more, not for less: divide. See 'One of many lamps'.",
            answer: |many| {
                many.estimate(|powers, lights, chance| {
                    let place = picked(powers, chance);
                    lights[place] * powers[place] / total(powers)
                })
            },
        },
    ]
}

pub(crate) fn of_share() -> Vec<Mistake<Arrival, f32>> {
    vec![
        Mistake {
            name: "the report's rule: from the eye only",
            diagnosis: "That is the report's rule. A mirror has one direction only, so nobody looked for \
                the lamp at it: what it shows of the lamp must count. See 'Once, and not twice'.",
            answer: |it| f32::from(u8::from(it.from_eye || !it.is_chosen)),
        },
        Mistake {
            name: "from the eye only, and no lamp is left out",
            diagnosis: "You count what the eye sees and nothing else. What mirrors show must count, and so \
                must lamps that are never looked at. See 'Once, and not twice'.",
            answer: |it| f32::from(u8::from(it.from_eye)),
        },
        Mistake {
            name: "all of it, always",
            diagnosis: "You count every lamp that a path comes upon. From a matte surface it has been looked \
                for already: its light counts twice. See 'Once, and not twice'.",
            answer: |_| 1.0,
        },
        Mistake {
            name: "nothing, ever",
            diagnosis: "You count no lamp that a path comes upon. Then the lamp itself is black in the \
                picture. See 'Once, and not twice'.",
            answer: |_| 0.0,
        },
        Mistake {
            name: "lamps that are never looked at are forgotten",
            diagnosis: "Eye and mirrors you have. A lamp with too little power to be looked at must count \
                where a path comes upon it, or its light is lost. See 'Once, and not twice'.",
            answer: |it| f32::from(u8::from(it.from_eye || it.from_mirror)),
        },
    ]
}
