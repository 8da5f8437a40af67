//! What readers get wrong about choices and about variances.

use common::exercise::Mistake;
use common::stats::estimate::Estimate;
use monte_carlo::naive;

use crate::cases::Choice;

/// The place that u picks, by weights.
fn pick(weights: &[f32], u: f32) -> usize {
    let mut left = u * weights.iter().sum::<f32>();
    let last = weights.iter().rposition(|&weight| weight > 0.0).unwrap_or(0);
    for (index, &weight) in weights.iter().enumerate() {
        left -= weight;
        if left < 0.0 {
            return index;
        }
    }
    last
}

pub(crate) fn of_one_of_many() -> Vec<Mistake<Choice, Estimate>> {
    vec![
        Mistake {
            name: "not divided by the probability",
            diagnosis: "You gave the value that was chosen. Its mean is a weighted mean of the values, not their \
                sum: divide by the probability of the choice. See 'One of many'.",
            answer: |choice| choice.estimate(|weights, values, u| values[pick(weights, u)]),
        },
        Mistake {
            name: "divided by the weight",
            diagnosis: "You divided by the weight. Weights don't add up to 1; the probability is the weight over \
                the sum of all. See 'One of many'.",
            answer: |choice| {
                choice.estimate(|weights, values, u| {
                    let index = pick(weights, u);
                    values[index] / weights[index]
                })
            },
        },
        Mistake {
            name: "all alike",
            diagnosis: "You chose all alike, whatever their weights. The mean is right, but the squares of your \
                estimates are not those of choices by weight. See 'One of many'.",
            answer: |choice| {
                choice.estimate(|_, values, u| {
                    let count = values.len() as f32;
                    values[((u * count) as usize).min(values.len() - 1)] * count
                })
            },
        },
        Mistake {
            name: "chosen by weight, counted as all alike",
            diagnosis: "You chose by weight and multiplied by the number of values, which is 1 over the probability \
                only if all are equally likely. See 'One of many'.",
            answer: |choice| {
                choice.estimate(|weights, values, u| values[pick(weights, u)] * values.len() as f32)
            },
        },
        Mistake {
            name: "u of 0 chooses what has no chance",
            diagnosis: "For u = 0 you chose a first value whose weight is 0, and divided by that. u may be 0 and is \
                never 1: what has been added up must be above u, not equal. See 'One of many'.",
            answer: |choice| {
                choice.estimate(|weights, values, u| {
                    let index = naive::pick(weights, u).min(weights.len() - 1);
                    values[index] * weights.iter().sum::<f32>() / weights[index]
                })
            },
        },
    ]
}

fn mean(samples: &[f32]) -> f64 {
    samples.iter().map(|&it| f64::from(it)).sum::<f64>() / samples.len() as f64
}

fn squares(samples: &[f32]) -> f64 {
    let mean = mean(samples);
    samples.iter().map(|&it| (f64::from(it) - mean) * (f64::from(it) - mean)).sum()
}

pub(crate) fn of_variance() -> Vec<Mistake<Vec<f32>, f64>> {
    vec![
        Mistake {
            name: "the mean of squares, as it is printed",
            diagnosis: "Far from 0 the mean of the squares and the square of the mean agree in all digits that an \
                f32 has: what is left is rounding. Add up squares of deviations, in f64. And this is not yet \
                unbiased. See 'How far off'.",
            answer: |samples| f64::from(naive::variance(samples)),
        },
        Mistake {
            name: "the mean of squares, unbiased",
            diagnosis: "You divide by the count less 1, but the mean of the squares and the square of the mean still \
                agree in all digits that an f32 has. Add up squares of deviations, in f64. See 'How far off'.",
            answer: |samples| {
                let count = samples.len() as f64;
                f64::from(naive::variance(samples)) * count / (count - 1.0)
            },
        },
        Mistake {
            name: "divided by the count",
            diagnosis: "You divided by the count. The mean of the samples is nearer to them than the true one, so \
                their squares are too small by (n - 1)/n: divide by the count less 1. See 'How far off'.",
            answer: |samples| squares(samples) / samples.len() as f64,
        },
        Mistake {
            name: "the standard deviation",
            diagnosis: "You took the root: that is the standard deviation. See 'How far off'.",
            answer: |samples| (squares(samples) / (samples.len() as f64 - 1.0)).sqrt(),
        },
        Mistake {
            name: "the variance of the mean",
            diagnosis: "You divided by the count once more: that is the variance of the mean of all samples, not of \
                one. See 'How far off'.",
            answer: |samples| {
                let count = samples.len() as f64;
                squares(samples) / (count - 1.0) / count
            },
        },
    ]
}
