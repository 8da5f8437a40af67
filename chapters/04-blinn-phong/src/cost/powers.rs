//! Ways to raise a cosine to a power: error against nanoseconds.

use std::hint::black_box;
use std::sync::Arc;

use common::cost::{Experiment, Method, Plot, Row, Table};
use common::math;
use common::sampler::Stream;

use super::root_mean_square;
use crate::power::power_of_cosine;
use crate::squaring;

/// A cosine, a whole exponent, and the power in `f64`.
struct Question {
    cosine: f32,
    exponent: u32,
    exact: f64,
}

const QUESTIONS: u64 = 8192;

/// How often a run asks all questions, to be long enough for a clock.
const REPEATS: u64 = 12;

pub(super) fn experiment() -> Experiment<'static> {
    let questions: Arc<Vec<Question>> = Arc::new((0..QUESTIONS).map(question).collect());
    Experiment {
        name: "powers",
        title: "The power of a highlight: cosines from 0.9 to 1, whole exponents from 1 to 1000",
        work_unit: "powers",
        error_metric: "RMS error of the power, which lies from 0 to 1, against f64",
        plot: Plot::ErrorOverTime("error of the power (RMS)"),
        methods: vec![
            platform_method(&questions),
            method("libm's powf", &questions, |it| math::pow(it.cosine, it.exponent as f32)),
            method("ours", &questions, |it| power_of_cosine(it.cosine, it.exponent as f32)),
            method("repeated squaring, f32", &questions, |it| {
                squaring::power(1.0, it.cosine, it.exponent)
            }),
            method("repeated squaring, f64", &questions, |it| {
                squaring::power(1.0, f64::from(it.cosine), it.exponent) as f32
            }),
            method("Schlick's fraction", &questions, |it| fraction(it.cosine, it.exponent as f32)),
        ],
        note: |table: &Table| {
            let [platform, libm, ours, ..] = &table.rows[..] else { return String::new() };
            let per = |row: &Row| row.nanoseconds() / platform.nanoseconds();
            format!(
                "The same bits on every machine take {:.1} times as long as the platform's by libm, \
                 and {:.1} times by ours.",
                per(libm),
                per(ours)
            )
        },
    }
}

fn question(number: u64) -> Question {
    let mut stream = Stream::of_trial(411, number);
    let cosine = stream.between(0.9, 1.0);
    let exponent = math::pow(1000.0, stream.uniform()) as u32;
    Question { cosine, exponent, exact: squaring::power(1.0, f64::from(cosine), exponent) }
}

// ANCHOR: fraction
/// A fraction that looks like the power: Schlick, "A fast alternative to Phong's specular model"
/// (Graphics Gems IV, 1994).
fn fraction(cosine: f32, exponent: f32) -> f32 {
    cosine / (exponent - exponent * cosine + cosine)
}
// ANCHOR_END: fraction

/// The platform's own power. Its last digits, and so those of its error, are its own: the error is
/// given in whole hundred-millionths, so that it is the same everywhere.
fn platform_method(questions: &Arc<Vec<Question>>) -> Method<'static> {
    let power = |it: &Question| platform(it.cosine, it.exponent as f32);
    let method = method("the platform's powf", questions, power);
    Method { error: (method.error * 1e8).round() / 1e8, ..method }
}

#[expect(clippy::disallowed_methods, reason = "it is measured here, and no pixel meets it")]
fn platform(cosine: f32, exponent: f32) -> f32 {
    cosine.powf(exponent)
}

fn method(
    label: &'static str,
    questions: &Arc<Vec<Question>>,
    power: impl Fn(&Question) -> f32 + 'static,
) -> Method<'static> {
    let error = |it: &Question| f64::from(power(it)) - it.exact;
    let error = root_mean_square(questions.iter().map(error));
    let questions = questions.clone();
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: REPEATS * QUESTIONS,
        error,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                let sum: f32 = black_box(&*questions).iter().map(&power).sum();
                black_box(sum);
            }
        }),
    }
}
