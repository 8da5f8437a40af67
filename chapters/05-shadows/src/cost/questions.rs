//! Two questions about a lamp: what is the nearest thing that way, and is there any before it?

use std::hint::black_box;
use std::sync::Arc;

use blinn_phong::scenes::brute_force;
use common::cost::{Experiment, Method, Plot, Table};
use common::sampler::Stream;
use common::tally::{Counts, Off, Tally};
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, SHAPE_TESTS, Shape, nearest};
use ray_casting::sphere::Sphere;
use triangles::brute::TRIANGLE_TESTS;
use triangles::bumpy;

use crate::hard::draw;
use crate::occluder::Occluder;
use crate::visibility::{End, between};

/// Lines of sight, and how often a run asks about all of them.
const LINES: u64 = 400;
const REPEATS: usize = 4;

/// From a point of one of the shapes to a lamp.
struct Line {
    hit: Hit,
    lamp: Vec3,
}

type Answer = fn(&[Box<dyn Shape>], &Line, &mut Counts) -> bool;
type Quick = fn(&[Box<dyn Shape>], &Line) -> bool;

pub(super) fn experiment() -> Experiment<'static> {
    let shapes = Arc::new(shapes());
    let lines: Arc<Vec<Line>> = Arc::new((0..LINES).filter_map(|it| line(&shapes, it)).collect());
    Experiment {
        name: "questions",
        title: "Is the lamp seen? Eight spheres and a bumpy ball of 1000 triangles",
        work_unit: "shape and triangle tests",
        error_metric: "answers that differ from those of the nearest hit in the same ray, per million",
        plot: Plot::TimeOver("shape and triangle tests"),
        methods: vec![
            method("the nearest hit", &shapes, &lines, nearest_hit::<Counts>, |shapes, line| {
                nearest_hit(shapes, line, &mut Off)
            }),
            method("the nearest, bounded", &shapes, &lines, bounded::<Counts>, |shapes, line| {
                bounded(shapes, line, &mut Off)
            }),
            method("any hit, bounded", &shapes, &lines, any_hit::<Counts>, |shapes, line| {
                any_hit(shapes, line, &mut Off)
            }),
        ],
        note,
    }
}

fn shapes() -> Vec<Box<dyn Shape>> {
    let ball = |number| {
        let mut stream = Stream::of_trial(5201, number);
        let center = 2.4 * draw::direction(&mut stream).as_vec3();
        Box::new(Sphere { center, radius: stream.between(0.5, 0.9) }) as Box<dyn Shape>
    };
    // What is quickly asked comes first.
    (0..8).map(ball).chain([brute_force(bumpy::sphere(1000))]).collect()
}

fn line(shapes: &[Box<dyn Shape>], number: u64) -> Option<Line> {
    let mut stream = Stream::of_trial(5202, number);
    let eye = 6.0 * draw::direction(&mut stream).as_vec3();
    let ray = Ray::new(eye, draw::in_cube(&mut stream, 1.0) - eye)?;
    let hit = nearest(shapes, &ray, &mut Off)?.hit;
    let lamp = 5.0 * draw::direction(&mut stream).as_vec3();
    // Only lamps above the surface are worth a question.
    let side = |toward: Vec3| hit.geometric.dot(toward) > 0.0;
    Some(Line { hit, lamp: if side(lamp - hit.point) { lamp } else { -lamp } })
}

fn ray(line: &Line) -> Ray {
    between(End::On(&line.hit), End::Free(line.lamp))
}

fn nearest_hit<T: Tally>(shapes: &[Box<dyn Shape>], line: &Line, tally: &mut T) -> bool {
    nearest(shapes, &ray(line), tally).is_none_or(|found| found.hit.t >= 1.0)
}

fn bounded<T: Tally>(shapes: &[Box<dyn Shape>], line: &Line, tally: &mut T) -> bool {
    let ray = ray(line);
    let mut limit = 1.0;
    for shape in shapes {
        let hit = match tally.counts() {
            Some(counts) => shape.hit_counted(&ray, limit, counts),
            None => shape.hit(&ray, limit),
        };
        limit = hit.map_or(limit, |hit| hit.t);
    }
    limit == 1.0
}

fn any_hit<T: Tally>(shapes: &[Box<dyn Shape>], line: &Line, tally: &mut T) -> bool {
    !shapes.blocks(&ray(line), 1.0, tally)
}

fn method(
    label: &'static str,
    shapes: &Arc<Vec<Box<dyn Shape>>>,
    lines: &Arc<Vec<Line>>,
    answer: Answer,
    quick: Quick,
) -> Method<'static> {
    let mut counts = Counts::default();
    let differ =
        |line: &&Line| answer(shapes, line, &mut counts) != nearest_hit(shapes, line, &mut Off);
    let different = lines.iter().filter(differ).count();
    let work = counts.of(SHAPE_TESTS) + counts.of(TRIANGLE_TESTS);
    let (shapes, lines_of_run) = (shapes.clone(), lines.clone());
    Method {
        label: label.into(),
        series: label,
        size: (work * REPEATS as u64) as f64,
        work: work * REPEATS as u64,
        error: 1e6 * different as f64 / lines.len() as f64,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                let seen = black_box(&*lines_of_run).iter().filter(|line| quick(&shapes, line));
                black_box(seen.count());
            }
        }),
    }
}

fn note(table: &Table) -> String {
    let [first, .., last] = &table.rows[..] else { return String::new() };
    format!(
        "Any hit takes {:.2} of the tests of the nearest hit, and {:.2} of its time.",
        last.work as f64 / first.work as f64,
        last.time.median / first.time.median
    )
}
