//! Three formulas for how much is reflected: error against nanoseconds.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, no_note};
use common::sampler::Stream;

use super::root_mean_square;
use crate::dielectric;
use crate::index::Index;
use crate::interface::Interface;
use crate::naive;
use crate::schlick;

const COUNT: u64 = 4096;
const REPEATS: u64 = 16;

/// An interface of glass and air, and the cosine of a ray on it.
struct Question {
    interface: Interface,
    cosine: f64,
}

/// Half the rays enter glass, half leave it, at every angle alike.
pub(super) fn experiment() -> Experiment<'static> {
    let questions: Rc<Vec<Question>> = Rc::new((0..COUNT).map(question).collect());
    Experiment {
        name: "reflectances",
        title: "How much an interface of glass reflects, half of the rays from within",
        work_unit: "reflectances",
        error_metric: "RMS error of the reflected part against f64 by sines",
        plot: Plot::ErrorOverTime("error of the part (RMS)"),
        methods: vec![
            method("Fresnel", &questions, |it| dielectric::reflectance(&it.interface, it.cosine)),
            method("Fresnel, f32", &questions, |it| {
                f64::from(naive::reflectance(it.interface.ratio() as f32, it.cosine as f32))
            }),
            method("Schlick", &questions, |it| schlick::reflectance(&it.interface, it.cosine)),
            method("Schlick, this side always, f32", &questions, |it| {
                f64::from(naive::schlick(it.interface.ratio() as f32, it.cosine as f32))
            }),
        ],
        note: no_note,
    }
}

fn question(number: u64) -> Question {
    let mut stream = Stream::of_trial(730, number);
    let into = Interface::new(Index::AIR, Index::GLASS);
    let interface = if number.is_multiple_of(2) { into } else { into.reversed() };
    Question { interface, cosine: f64::from(stream.uniform()) }
}

fn method<F: Fn(&Question) -> f64 + 'static>(
    label: &'static str,
    questions: &Rc<Vec<Question>>,
    part: F,
) -> Method<'static> {
    let errors = questions.iter().map(|it| part(it) - super::by_sines(&it.interface, it.cosine));
    let error = root_mean_square(errors);
    let questions = questions.clone();
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: COUNT * REPEATS,
        error,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                let sum: f64 = black_box(&*questions).iter().map(&part).sum();
                black_box(sum);
            }
        }),
    }
}
