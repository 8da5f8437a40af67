//! Every form of the slab test: wrong answers against nanoseconds.

use std::hint::black_box;
use std::sync::Arc;

use common::cost::{Experiment, Method, Plot, Row, Table, no_note};
use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::aabb::Aabb;
use crate::hard::draw::allowed;
use crate::hard::in_plane::{IN_PLANE, LOPSIDED, in_plane_ray, with_zeros};
use crate::naive::{
    PlainRay, folded, glam_vectors, kay_kajiya, natural, old_weekend, pbrt_fast, pbrt_loop, smits,
    tavian_2015, tavian_2022,
};
use crate::oracle::Verdict;
use crate::slab::BoxRay;

/// Boxes that one ray is asked about in a row, as in a tree: so a form that jumps by the direction's
/// signs jumps the same way each time, which a processor can guess.
const IN_A_ROW: u64 = 32;
/// Rays and boxes of one run.
const PAIRS: u64 = 128 * IN_A_ROW;
/// How often a run asks all of them, to be long enough for a clock.
const REPEATS: u64 = 16;
/// Rays with zeros of either sign.
const ZEROS: u64 = 4096;

/// Rays made ready in both ways, with a box each.
struct Pairs {
    plain: Vec<PlainRay>,
    ready: Vec<BoxRay>,
    boxes: Vec<Aabb>,
}

/// The scoreboard of the rays in a face's plane.
pub(super) fn in_plane() -> Experiment<'static> {
    Experiment {
        name: "in-plane",
        title: "Slab tests: rays in the plane of a face, of which all meet the box",
        work_unit: "box tests",
        error_metric: "wrong answers to the 48 rays in the planes of a box's faces",
        plot: Plot::ErrorOverTime("wrong answers of 48"),
        methods: methods(|meets| {
            let rays = (0..IN_PLANE).map(|index| in_plane_ray(&LOPSIDED, index, 0.0));
            rays.filter(|ray| !meets(ray, &LOPSIDED)).count() as f64
        }),
        note,
    }
}

/// The scoreboard of the zeros with a minus.
pub(super) fn zeros() -> Experiment<'static> {
    Experiment {
        name: "zeros",
        title: "Slab tests: directions with one or two zeros, of either sign",
        work_unit: "box tests",
        error_metric: "wrong answers to 4,096 such rays, where f64 has one",
        plot: Plot::ErrorOverTime("wrong answers of 4,096"),
        methods: methods(|meets| {
            (0..ZEROS).filter(|&trial| !is_right_about_zeros(trial, meets)).count() as f64
        }),
        note: no_note,
    }
}

/// Whether a form is right about the ray with zeros number `trial`, where `f64` has an answer.
fn is_right_about_zeros(trial: u64, meets: impl Fn(&Ray, &Aabb) -> bool) -> bool {
    let (signed, _, bounds) = with_zeros(trial);
    let met = meets(&signed, &bounds);
    match allowed(&signed, &bounds) {
        Verdict::Met => met,
        Verdict::Missed => !met,
        Verdict::Close => true,
    }
}

fn note(table: &Table) -> String {
    let [first, .., ours] = &table.rows[..] else { return String::new() };
    let ratio = ours.nanoseconds() / first.nanoseconds();
    let fastest = |best: f64, row: &Row| best.min(row.nanoseconds());
    let least = table.rows.iter().fold(f64::INFINITY, fastest);
    format!(
        "Ours takes {ratio:.2} times as long as the natural form, and {:.2} times as long as the fastest.",
        ours.nanoseconds() / least
    )
}

/// All forms, ours last; `wrong` counts the wrong answers of one.
fn methods(wrong: impl Fn(&dyn Fn(&Ray, &Aabb) -> bool) -> f64) -> Vec<Method<'static>> {
    let pairs = &Arc::new(pairs());
    vec![
        form("natural Rust", pairs, &wrong, natural),
        form("glam vectors", pairs, &wrong, glam_vectors),
        form("Kay and Kajiya 1986", pairs, &wrong, kay_kajiya),
        form("Smits 1998", pairs, &wrong, smits),
        form("RTIOW, old form", pairs, &wrong, old_weekend),
        form("Barnes 2015", pairs, &wrong, tavian_2015),
        form("Barnes 2022", pairs, &wrong, tavian_2022),
        form("folded", pairs, &wrong, folded),
        form("pbrt, loop", pairs, &wrong, pbrt_loop),
        form("pbrt, for trees", pairs, &wrong, pbrt_fast),
        ours(pairs, &wrong),
    ]
}

fn form<F>(
    label: &'static str,
    pairs: &Arc<Pairs>,
    wrong: impl Fn(&dyn Fn(&Ray, &Aabb) -> bool) -> f64,
    meets: F,
) -> Method<'static>
where
    F: Fn(&PlainRay, &Aabb, f32) -> bool + 'static,
{
    let error = wrong(&|ray, bounds| meets(&PlainRay::from(ray), bounds, f32::INFINITY));
    let pairs = pairs.clone();
    method(label, error, move || {
        let pairs = pairs.plain.iter().zip(&pairs.boxes);
        pairs.filter(|(ray, bounds)| meets(ray, bounds, 1e9)).count()
    })
}

fn ours(
    pairs: &Arc<Pairs>,
    wrong: impl Fn(&dyn Fn(&Ray, &Aabb) -> bool) -> f64,
) -> Method<'static> {
    let error =
        wrong(&|ray, bounds| BoxRay::new(ray, bounds).enter(bounds, f32::INFINITY).is_some());
    let pairs = pairs.clone();
    method("ours", error, move || {
        let pairs = pairs.ready.iter().zip(&pairs.boxes);
        pairs.filter(|(ray, bounds)| ray.enter(bounds, 1e9).is_some()).count()
    })
}

fn method(label: &'static str, error: f64, count: impl Fn() -> usize + 'static) -> Method<'static> {
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: REPEATS * PAIRS,
        error,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                black_box(count());
            }
        }),
    }
}

/// Rays, and for each some boxes in no order, of which it is aimed at half.
fn pairs() -> Pairs {
    let scene = Aabb { min: Vec3::splat(-7.0), max: Vec3::splat(7.0) };
    let mut pairs = Pairs { plain: Vec::new(), ready: Vec::new(), boxes: Vec::new() };
    for number in 0..PAIRS {
        let [mut of_ray, mut of_box] =
            [(892, number / IN_A_ROW), (891, number)].map(|(seed, at)| Stream::of_trial(seed, at));
        let (origin, target) = (point(&mut of_ray, 6.0), point(&mut of_ray, 3.0));
        let ray = Ray { origin, direction: target - origin };
        let half = point(&mut of_box, 1.0).abs();
        // On the ray, or anywhere.
        let on_ray = origin + of_box.uniform() * ray.direction + half * point(&mut of_box, 0.9);
        let middle = if number.is_multiple_of(2) { on_ray } else { point(&mut of_box, 4.0) };
        pairs.plain.push(PlainRay::from(&ray));
        pairs.ready.push(BoxRay::new(&ray, &scene));
        pairs.boxes.push(Aabb { min: middle - half, max: middle + half });
    }
    pairs
}

/// A point of the cube from -`side` to `side`.
fn point(stream: &mut Stream, side: f32) -> Vec3 {
    let x = stream.between(-side, side);
    let y = stream.between(-side, side);
    Vec3::new(x, y, stream.between(-side, side))
}
