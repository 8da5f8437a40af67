//! Mistakes in closed forms: exercises 14.3 and 14.4.

use common::exercise::Mistake;
use common::film::Color;

use crate::cases::{Load, Room};
use crate::solutions::{survival, variance};

/// Albedo and survival.
fn of(room: &Room) -> (f64, f64) {
    (room.albedo.into(), room.survival.into())
}

pub(crate) fn of_variance() -> Vec<Mistake<Room, Option<f64>>> {
    vec![
        Mistake {
            name: "always finite",
            diagnosis: "You give a number where it is infinite: below the albedo's square the rare long \
                        paths carry so much that the variance has no bound, and your formula turns \
                        negative. See 'The price in noise'.",
            answer: |room| {
                let (albedo, survival) = of(room);
                let (square, dark) = (albedo * albedo, (1.0 - albedo) * (1.0 - albedo));
                Some(square * (1.0 - survival) / (dark * (survival - square)))
            },
        },
        Mistake {
            name: "the mean of the squares",
            diagnosis: "You gave the mean of X². Its variance is that minus the square of the mean. See \
                        'The price in noise'.",
            answer: |room| {
                let (albedo, survival) = of(room);
                let mean = 1.0 / (1.0 - albedo);
                variance(albedo, survival).map(|variance| variance + mean * mean)
            },
        },
        Mistake {
            name: "the standard deviation",
            diagnosis: "You took the root: that is the standard deviation. See 'The price in noise'.",
            answer: |room| {
                let (albedo, survival) = of(room);
                variance(albedo, survival).map(f64::sqrt)
            },
        },
        Mistake {
            name: "finite down to the albedo",
            diagnosis: "You say that it is infinite as soon as paths grow heavier, below the albedo. They \
                        do, but they grow rarer faster: the bound is the albedo's square. See 'The \
                        price in noise'.",
            answer: |room| {
                let (albedo, survival) = of(room);
                variance(albedo, survival).filter(|_| survival > albedo)
            },
        },
    ]
}

pub(crate) fn of_survival() -> Vec<Mistake<Load, f32>> {
    vec![
        Mistake {
            name: "the mean of the colours",
            diagnosis: "You take the mean of the three colours. It is right on average, but light of \
                        one colour ends three times as often as it should, and the survivors are \
                        three times as bright: take the brightest. See 'By what a path carries'.",
            answer: |load| {
                let mean = load.throughput.element_sum() / 3.0;
                survival(Color::splat(mean), load.threshold)
            },
        },
        Mistake {
            name: "above one",
            diagnosis: "You give a probability above 1 where the path carries more than the threshold. \
                        It would be divided by that, and grow darker. See 'By what a path carries'.",
            answer: |load| {
                let largest = load.throughput.max_element() / load.threshold;
                if largest > 1.0 { largest } else { survival(load.throughput, load.threshold) }
            },
        },
        Mistake {
            name: "no least probability",
            diagnosis: "You go below 2⁻¹². Random numbers have 24 binary digits, and such a small \
                        probability comes true far too often. See 'Twenty-four bits'.",
            answer: |load| (load.throughput.max_element() / load.threshold).min(1.0),
        },
        Mistake {
            name: "black paths go on",
            diagnosis: "A black path goes on in one of 4096 cases. It can't bring anything: give 0. See \
                        'By what a path carries'.",
            answer: |load| {
                let largest = load.throughput.max_element() / load.threshold;
                largest.clamp(1.0 / 4096.0, 1.0)
            },
        },
    ]
}
