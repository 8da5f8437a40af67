//! Mistakes with rows of mirrors: exercises 6.2, 6.4 and 6.5.

use common::exercise::Mistake;
use whitted::exercises::Node;

use crate::cases::{Mirrors, Way};
use crate::forest::Forest;
use crate::solutions::along;

/// The row, with what is added of a surface and whether the next one is followed left open.
fn walk(
    way: &Way,
    share: impl Fn(f32, f32) -> f32,
    goes_on: impl Fn(u32, f32, f32) -> bool,
) -> f32 {
    let (mut sum, mut throughput) = (0.0, 1.0);
    for (followed, met) in (1..).zip(&way.surfaces) {
        sum += share(throughput, met.mirror) * met.light;
        throughput *= met.mirror;
        if !goes_on(followed, throughput, met.mirror) {
            break;
        }
    }
    sum
}

pub(crate) fn of_along() -> Vec<Mistake<Way, f32>> {
    vec![
        Mistake {
            name: "one mirror ray too few",
            diagnosis: "Your depth test stops one ray early: a depth of 1 follows one mirror ray, and \
                        a depth of 0 none. Compare the number of the ray with `<=`. See 'Where \
                        following ends'.",
            answer: |way| along(&way.surfaces, way.depth.saturating_sub(1), way.cutoff),
        },
        Mistake {
            name: "the eye's surface counted as a mirror's",
            diagnosis: "You count surfaces where the depth counts mirror rays. What the eye sees first \
                        is met by no mirror ray: at depth 0 it is still there. See 'Where following \
                        ends'.",
            answer: |way| match way.depth {
                0 => 0.0,
                depth => along(&way.surfaces, depth - 1, way.cutoff),
            },
        },
        Mistake {
            name: "one mirror ray too many",
            diagnosis: "Your depth test stops one ray late: at depth 0 not even the first mirror ray is \
                        followed. See 'Where following ends'.",
            answer: |way| along(&way.surfaces, way.depth + 1, way.cutoff),
        },
        Mistake {
            name: "adding instead of weighing",
            diagnosis: "You add what the mirror ray brings without its weight. A mirror of 0.5 returns \
                        half: every surface counts by the product of all mirrors before it. See 'A \
                        surface's own light, and the mirror's'.",
            answer: |way| {
                walk(way, |_, _| 1.0, |ray, through, _| ray <= way.depth && through > way.cutoff)
            },
        },
        Mistake {
            name: "a mixture instead of a sum",
            diagnosis: "You took (1 - mirror) of the surface's own light. `light` is what it sends, \
                        mirror or not: only the mirror ray is weighed. See 'A surface's own light, and \
                        the mirror's'.",
            answer: |way| {
                let share = |throughput: f32, mirror: f32| throughput * (1.0 - mirror);
                walk(way, share, |ray, through, _| ray <= way.depth && through > way.cutoff)
            },
        },
        Mistake {
            name: "the last weight against the cut-off",
            diagnosis: "You compare the cut-off with the last mirror alone. Ten mirrors of 0.5 leave a \
                        thousandth, though each returns half: compare the throughput. See 'Where \
                        following ends'.",
            answer: |way| {
                walk(
                    way,
                    |throughput, _| throughput,
                    |ray, _, mirror| ray <= way.depth && mirror > way.cutoff,
                )
            },
        },
    ]
}

/// The answer of a function that calls itself, which the check must notice before the stack is full.
fn recursive(meet: &dyn Fn(usize) -> Node, number: usize) -> f64 {
    let Node { light, branches } = meet(number);
    branches.iter().fold(light, |sum, &(branch, weight)| sum + weight * recursive(meet, branch))
}

/// Nodes with what each is weighed by.
type Weighed = [(usize, f64)];

/// A loop whose list holds what `next` makes of a node's throughput and its branches.
fn listed(meet: &dyn Fn(usize) -> Node, next: fn(f64, &Weighed) -> Vec<(usize, f64)>) -> f64 {
    let (mut sum, mut waiting) = (0.0, vec![(0, 1.0)]);
    while let Some((number, throughput)) = waiting.pop() {
        let Node { light, branches } = meet(number);
        sum += throughput * light;
        waiting.extend(next(throughput, &branches));
    }
    sum
}

pub(crate) fn of_total() -> Vec<Mistake<Forest, f64>> {
    vec![
        Mistake {
            name: "it calls itself",
            diagnosis: "Your function calls itself, so each node of a row takes a piece of the stack. A \
                        million nodes would end the program. Keep what is left to do in a list: see \
                        'The same as a loop'.",
            answer: |forest| forest.asked(|meet| recursive(meet, 0)),
        },
        Mistake {
            name: "the first branch alone",
            diagnosis: "You follow the first branch of each node and forget the others. Put all of them \
                        into the list: see 'The same as a loop'.",
            answer: |forest| {
                forest.asked(|meet| {
                    listed(meet, |throughput, branches| {
                        let first = branches.first();
                        first
                            .map(|&(node, weight)| (node, throughput * weight))
                            .into_iter()
                            .collect()
                    })
                })
            },
        },
        Mistake {
            name: "a branch gets its brother's weight as well",
            diagnosis: "You multiply one throughput by the weight of each branch in turn, so the second \
                        branch is weighed by both. Each starts from the throughput of the node: see \
                        'The same as a loop'.",
            answer: |forest| {
                forest.asked(|meet| {
                    listed(meet, |mut throughput, branches| {
                        let mut list = Vec::new();
                        for &(node, weight) in branches {
                            throughput *= weight;
                            list.push((node, throughput));
                        }
                        list
                    })
                })
            },
        },
        Mistake {
            name: "the last weight instead of the product",
            diagnosis: "You store each branch with its own weight alone. What reaches the eye is the \
                        product of all weights on the way: see 'The same as a loop'.",
            answer: |forest| forest.asked(|meet| listed(meet, |_, branches| branches.to_vec())),
        },
    ]
}

/// The smallest depth at which `left`, a function of it, is at most the limit.
fn smallest(case: &Mirrors, left: fn(f64, i32) -> f64) -> u32 {
    (0..1_000_000).find(|&depth| left(case.mirror, depth as i32) <= case.missing).unwrap_or(0)
}

/// ρ to the power n, as a product.
fn power(mirror: f64, exponent: i32) -> f64 {
    (0..exponent).map(|_| mirror).product()
}

pub(crate) fn of_depth_needed() -> Vec<Mistake<Mirrors, u32>> {
    vec![
        Mistake {
            name: "one too deep",
            diagnosis: "You count ρⁿ as what is missing at depth n. At depth 0 the first surface is \
                        already there, so ρⁿ⁺¹ is missing: see 'A series'.",
            answer: |case| smallest(case, power),
        },
        Mistake {
            name: "missing in units of one mirror's light",
            diagnosis: "What you compare is ρⁿ⁺¹ / (1 - ρ), the missing light in units of what one \
                        mirror sends. The limit is a part of all of the light, which is 1 / (1 - ρ): \
                        divide. See 'A series'.",
            answer: |case| smallest(case, |rho, depth| power(rho, depth + 1) / (1.0 - rho)),
        },
        Mistake {
            name: "the last term instead of the rest",
            diagnosis: "You stop where the next mirror's own share is small. All those behind it are \
                        missing, too, and together they are ρⁿ⁺¹ of all: see 'A series'.",
            answer: |case| smallest(case, |rho, depth| power(rho, depth + 1) * (1.0 - rho)),
        },
    ]
}
