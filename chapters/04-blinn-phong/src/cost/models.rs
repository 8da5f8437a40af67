//! The models of highlights: error against nanoseconds.

use std::hint::black_box;
use std::sync::Arc;

use common::cost::{Experiment, Method, Plot, no_note};
use common::film::Color;
use common::sampler::Stream;
use glam::{DVec3, Vec2, Vec3};

use super::root_mean_square;
use crate::light::Arriving;
use crate::material::{BlinnPhong, Surface};
use crate::models::{Blinn, Lambert, Model, Normalized, Phong};
use crate::paint::Paint;
use crate::squaring;

/// A lamp, an eye and a normal, all on one side of the surface.
struct Question {
    normal: Vec3,
    toward_eye: Vec3,
    arriving: Arriving,
}

const QUESTIONS: u64 = 8192;

/// How often a run asks all questions, to be long enough for a clock.
const REPEATS: u64 = 12;

const EXPONENT: u32 = 25;
const DIFFUSE: f32 = 0.7;
const SPECULAR: f32 = 0.3;

pub(super) fn experiment() -> Experiment<'static> {
    let questions: Arc<Vec<Question>> = Arc::new((0..QUESTIONS).map(question).collect());
    Experiment {
        name: "models",
        title: "What a surface returns of one lamp, by four models (exponent 25)",
        work_unit: "lamps",
        error_metric: "RMS error of what is returned, against the same model in f64",
        plot: Plot::ErrorOverTime("error of what is returned (RMS)"),
        methods: vec![
            method::<Lambert>("Lambert", &questions, |_, _| 0.0),
            method::<Phong>("Phong", &questions, |it, n| {
                let mirrored = 2.0 * n.dot(it.light()) * n - it.light();
                lobe(mirrored.dot(it.eye()))
            }),
            method::<Blinn>("Blinn-Phong", &questions, |it, n| lobe(n.dot(it.half()))),
            method::<Normalized>("Blinn-Phong, normalized", &questions, |it, n| {
                // (n + 2)(n + 4) / 8 (n + 2^(-n/2)) for n = 25.
                let factor = 27.0 * 29.0 / (8.0 * (25.0 + 1.0 / 4096.0 / f64::sqrt(2.0)));
                factor * n.dot(it.light()) * lobe(n.dot(it.half()))
            }),
        ],
        note: no_note,
    }
}

impl Question {
    fn light(&self) -> DVec3 {
        self.arriving.toward.as_dvec3()
    }

    fn eye(&self) -> DVec3 {
        self.toward_eye.as_dvec3()
    }

    fn half(&self) -> DVec3 {
        (self.light() + self.eye()).normalize()
    }

    fn exact(&self, strength: fn(&Self, DVec3) -> f64) -> f64 {
        let normal = self.normal.as_dvec3();
        let cosine = normal.dot(self.light());
        f64::from(DIFFUSE) * cosine + f64::from(SPECULAR) * strength(self, normal)
    }
}

fn lobe(cosine: f64) -> f64 {
    squaring::power(1.0, cosine.clamp(0.0, 1.0), EXPONENT)
}

fn question(number: u64) -> Question {
    let mut stream = Stream::of_trial(412, number);
    let mut direction = || {
        let mut component = || stream.between(-1.0, 1.0);
        Vec3::new(component(), component(), component()).normalize_or(Vec3::X)
    };
    let normal = direction();
    let mut upper = || {
        let direction = direction();
        if direction.dot(normal) < 0.0 { -direction } else { direction }
    };
    let (toward_eye, toward) = (upper(), upper());
    let arriving = Arriving { toward, distance: 3.0, color: Color::ONE };
    Question { normal, toward_eye, arriving }
}

fn surface() -> Surface {
    let paint = Paint::Plain(Color::splat(DIFFUSE));
    BlinnPhong::glossy(paint, Color::splat(SPECULAR), EXPONENT as f32).at::<false>(Vec2::ZERO)
}

fn method<M: Model>(
    label: &'static str,
    questions: &Arc<Vec<Question>>,
    strength: fn(&Question, DVec3) -> f64,
) -> Method<'static> {
    let surface = surface();
    let returned =
        move |it: &Question| M::returned(&surface, it.normal, it.toward_eye, &it.arriving);
    let error = |it: &Question| f64::from(returned(it).x) - it.exact(strength);
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
                let sum: Color = black_box(&*questions).iter().map(returned).sum();
                black_box(sum);
            }
        }),
    }
}
