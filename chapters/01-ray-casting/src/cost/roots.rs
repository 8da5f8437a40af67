//! Formulas for the sphere: error against nanoseconds.

use std::hint::black_box;
use std::sync::Arc;

use common::cost::{Experiment, Method, Plot, Row, Table};
use common::math;
use common::sampler::Stream;
use glam::Vec3;

use super::root_mean_square;
use crate::crossing::Crossing;
use crate::direction::unit;
use crate::double::{self, DoubleSphere};
use crate::naive::{self, NaiveSphere};
use crate::ray::Ray;
use crate::sphere::Sphere;

/// A ray, the sphere it is asked about, and what `f64` answers: NaN for a miss.
struct Question {
    sphere: Sphere,
    ray: Ray,
    exact: f64,
}

/// Rays of each kind; the three kinds alternate.
const EACH: u64 = 4096;

/// How often a run asks all questions, to be long enough for a clock.
const REPEATS: u64 = 16;

/// Four formulas on the same rays.
pub(super) fn experiment() -> Experiment<'static> {
    let questions: Arc<Vec<Question>> = Arc::new((0..3 * EACH).map(question).collect());
    Experiment {
        name: "sphere-roots",
        title: "Where a ray meets a sphere: a third of the spheres near, a third far, a third huge",
        work_unit: "sphere tests",
        error_metric: "RMS of the error of t over the smaller of t and the radius, against f64; \
                       a wrong hit or miss counts 1",
        plot: Plot::ErrorOverTime("error of t (RMS, relative)"),
        methods: vec![
            method("textbook, f32", &questions, |sphere, ray| NaiveSphere(*sphere).crossing(ray)),
            method("projected, f32", &questions, naive::projected_crossing),
            method("ours, f32", &questions, Sphere::crossing),
            method("textbook, f64", &questions, |sphere, ray| DoubleSphere(*sphere).crossing(ray)),
        ],
        note: |table: &Table| {
            let [textbook, _, ours, double] = &table.rows[..] else { return String::new() };
            let per = |row: &Row| row.nanoseconds() / textbook.nanoseconds();
            format!(
                "Ours takes {:.1} times as long as the textbook in f32; the textbook in f64 {:.1} times.",
                per(ours),
                per(double)
            )
        },
    }
}

/// A ray from 2 to 10 away, from 10,000 away, or from just above a sphere of 10^5 to 10^7.
fn question(number: u64) -> Question {
    let mut stream = Stream::of_trial(301, number);
    let mut cube = |side: f32| {
        let mut component = || stream.between(-side, side);
        Vec3::new(component(), component(), component())
    };
    let way = unit(cube(1.0)).unwrap_or(Vec3::X);
    let (sphere, origin, aim) = match number % 3 {
        0 => (Sphere { center: Vec3::ZERO, radius: 1.0 }, way * 6.0, cube(1.2)),
        1 => (Sphere { center: Vec3::ZERO, radius: 1.0 }, way * 1e4, cube(1.2)),
        _ => {
            let radius = math::pow(10.0, 6.0 + cube(1.0).x).floor();
            let sphere = Sphere { center: Vec3::Y * -radius, radius };
            (sphere, cube(10.0).with_y(2.0), cube(20.0).with_y(0.0))
        }
    };
    let ray = Ray { origin, direction: unit(aim - origin).unwrap_or(Vec3::X) };
    let exact = double::crossing(&sphere, &ray, f64::from(sphere.radius)).enter;
    Question { sphere, ray, exact }
}

fn method<F>(label: &'static str, questions: &Arc<Vec<Question>>, crossing: F) -> Method<'static>
where
    F: Fn(&Sphere, &Ray) -> Option<Crossing> + 'static,
{
    let enter = move |question: &Question| {
        crossing(&question.sphere, &question.ray).map_or(f32::NAN, |crossing| crossing.enter)
    };
    let error = root_mean_square(questions.iter().map(|question| error(question, enter(question))));
    let questions = questions.clone();
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: REPEATS * 3 * EACH,
        error,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                let sum: f32 = black_box(&*questions).iter().map(&enter).sum();
                black_box(sum);
            }
        }),
    }
}

/// How wrong an answer is, from 0 to 1 and above.
fn error(question: &Question, enter: f32) -> f64 {
    match (question.exact.is_nan(), enter.is_nan()) {
        (true, true) => 0.0,
        (false, false) => {
            let unit = question.exact.abs().min(f64::from(question.sphere.radius));
            (f64::from(enter) - question.exact).abs() / unit
        }
        _ => 1.0,
    }
}
