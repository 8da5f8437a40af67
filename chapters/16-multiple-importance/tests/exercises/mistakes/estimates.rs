//! What people get wrong about estimates.

use common::exercise::Mistake;
use glam::{Vec2, Vec3};
use multiple_importance::heuristic::Heuristic::Balance;
use multiple_importance::naive;
use multiple_importance::place::Place;

use crate::cases::{Found, Site};
use crate::solutions::{brings, densities};

pub(crate) fn of_combined() -> Vec<Mistake<Site, Found>> {
    vec![
        Mistake {
            name: "added",
            diagnosis: "Each estimate is right by itself, so their sum is twice the light. Give each a \
                share. See 'Shares that add up to one'.",
            answer: |site| {
                site.of_each(|place, light, direction| naive::added(place, [light, direction]))
            },
        },
        Mistake {
            name: "the mean of both",
            diagnosis: "Half and half add up to 1, so the mean is right, but a quarter of the worse one's \
                variance stays. Let the densities decide. See 'Why balance'.",
            answer: |site| {
                site.of_each(|place, light, direction| naive::averaged(place, [light, direction]))
            },
        },
        Mistake {
            name: "weighted, and halved",
            diagnosis: "The weights share the light already. Their sum is all of it: take no mean \
                afterwards. See 'Shares that add up to one'.",
            answer: |site| {
                site.of_each(|place, light, direction| {
                    place.combined(Balance, [light, direction]) / 2.0
                })
            },
        },
        Mistake {
            name: "not divided",
            diagnosis: "You gave each its share, and did not divide by the density with which it was \
                chosen. See 'Shares that add up to one'.",
            answer: |site| site.of_each(undivided),
        },
        Mistake {
            name: "one weight for two directions",
            diagnosis: "You weighed the lobe's direction by 1 minus the share of the lamp's direction. \
                Shares add up to 1 in each direction: weigh each by its own densities. See 'Shares \
                that add up to one'.",
            answer: |site| site.of_each(one_weight),
        },
        Mistake {
            name: "only the lamp's part",
            diagnosis: "You counted the lamp's share and not the lobe's. See 'Shares that add up to one'.",
            answer: |site| {
                site.of_each(|place, light, _| {
                    let incoming = place.sample_light(light);
                    brings(place, incoming) / densities(place, incoming)
                })
            },
        },
    ]
}

fn undivided(place: &Place, light: Vec2, direction: Vec2) -> f32 {
    let share =
        |own: f32, incoming: Vec3| own / densities(place, incoming) * brings(place, incoming);
    let [to_lamp, of_lobe] = [place.sample_light(light), place.sample_direction(direction)];
    share(place.light_pdf(to_lamp), to_lamp) + share(place.direction_pdf(of_lobe), of_lobe)
}

fn one_weight(place: &Place, light: Vec2, direction: Vec2) -> f32 {
    let to_lamp = place.sample_light(light);
    let share = place.light_pdf(to_lamp) / densities(place, to_lamp);
    share * place.by_light(light) + (1.0 - share) * place.by_direction(direction)
}

pub(crate) fn of_one_of_two() -> Vec<Mistake<Site, Found>> {
    vec![
        Mistake {
            name: "half of the light",
            diagnosis: "You divided by the sum of both densities. Each strategy is chosen half of the \
                time, so the direction's density is half that sum. See 'Shares that add up to one'.",
            answer: |site| {
                site.of_one(|place, chance, u| {
                    let incoming = chosen(place, chance, u);
                    brings(place, incoming) / densities(place, incoming)
                })
            },
        },
        Mistake {
            name: "the density of the chosen one",
            diagnosis: "You divided by the density of the strategy that was chosen. That is right on \
                average, but where it is small the other one's is not: use both. See 'Why balance'.",
            answer: |site| site.of_one(chosen_alone),
        },
        Mistake {
            name: "twice the light",
            diagnosis: "You divided the chosen estimate by its chance, 1/2, and gave it no share: each \
                strategy brings all of the light. See 'Shares that add up to one'.",
            answer: |site| site.of_one(|place, chance, u| 2.0 * chosen_alone(place, chance, u)),
        },
        Mistake {
            name: "the lobe's density always",
            diagnosis: "You divided by the density of the lobe though the direction may have come from \
                the lamp. See 'Shares that add up to one'.",
            answer: |site| site.of_one(|place, chance, u| place.arriving(chosen(place, chance, u))),
        },
    ]
}

fn chosen(place: &Place, chance: f32, u: Vec2) -> Vec3 {
    if chance < 0.5 { place.sample_light(u) } else { place.sample_direction(u) }
}

fn chosen_alone(place: &Place, chance: f32, u: Vec2) -> f32 {
    if chance < 0.5 { place.by_light(u) } else { place.by_direction(u) }
}
