//! The exercises of chapter 8, judged.

mod mistakes;
mod solutions;

use boxes::aabb::Aabb;
use boxes::exercises::{enter, meets, pad, smallest_box, surface_area};
use boxes::oracle::{Verdict, crossing, verdict};
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use common::sampler::Stream;
use glam::{DVec3, Vec3};
use ray_casting::ray::Ray;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

/// A point of the cube from -`side` to `side`.
fn point(stream: &mut Stream, side: f32) -> Vec3 {
    let x = stream.between(-side, side);
    let y = stream.between(-side, side);
    Vec3::new(x, y, stream.between(-side, side))
}

#[test]
fn exercise_8_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "8.1",
        title: "The smallest box",
        section: "The smallest box",
        cases: clouds,
        expected: |points| by_sorting(points),
        agree: |_, expected, yours| agree::options(expected, yours, |a, b| a == b),
        yours: |points| smallest_box(points),
        solution: |points| solutions::smallest_box(points),
        mistakes: mistakes::smallest_box(),
    }
    .judge()
}

fn clouds() -> Vec<Vec<Vec3>> {
    let (a, b) = (Vec3::new(1.0, -2.0, 3.0), Vec3::new(-4.0, 5.0, 6.0));
    let bad = [Vec3::new(9.0, f32::NAN, -9.0), Vec3::new(-9.0, 9.0, f32::NEG_INFINITY)];
    let mut clouds = vec![
        vec![a, b],
        vec![a + 10.0, b + 10.0],
        vec![a - 10.0, b - 10.0],
        vec![a],
        vec![a, b, Vec3::NAN],
        vec![a, bad[0], b],
        vec![bad[1], b, a],
        vec![],
        bad.to_vec(),
    ];
    clouds.extend((0..100).map(|trial| {
        let mut stream = Stream::of_trial(81, trial);
        let middle = point(&mut stream, 20.0);
        let mut points: Vec<Vec3> = (0..7).map(|_| middle + point(&mut stream, 3.0)).collect();
        if trial.is_multiple_of(3) {
            points[trial as usize % 7].y = f32::NAN;
        }
        points
    }));
    clouds
}

/// By sorting the coordinates of each axis, in f64.
fn by_sorting(points: &[Vec3]) -> Option<Aabb> {
    let finite: Vec<DVec3> =
        points.iter().filter(|it| it.is_finite()).map(|it| it.as_dvec3()).collect();
    let sorted = |axis: usize| {
        let mut all: Vec<f64> = finite.iter().map(|point| point[axis]).collect();
        all.sort_by(f64::total_cmp);
        Some([*all.first()? as f32, *all.last()? as f32])
    };
    let [x, y, z] = [sorted(0)?, sorted(1)?, sorted(2)?];
    Some(Aabb { min: Vec3::new(x[0], y[0], z[0]), max: Vec3::new(x[1], y[1], z[1]) })
}

#[test]
fn exercise_8_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "8.2",
        title: "The area of a box",
        section: "Large faces are met more often",
        cases: areas,
        expected: exact_area,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-6),
        yours: surface_area,
        solution: solutions::surface_area,
        mistakes: mistakes::surface_area(),
    }
    .judge()
}

fn areas() -> Vec<Aabb> {
    let sized = |size: Vec3| Aabb {
        min: Vec3::new(4.0, -7.0, 10.0),
        max: Vec3::new(4.0, -7.0, 10.0) + size,
    };
    let mut boxes = vec![
        sized(Vec3::ONE),
        sized(Vec3::new(1.0, 2.0, 3.0)),
        sized(Vec3::new(3.0, 1.0, 2.0)),
        sized(Vec3::new(2.0, 3.0, 0.0)),
        sized(Vec3::ZERO),
        sized(Vec3::new(2.0, -1.0, 3.0)),
        sized(Vec3::new(-2.0, -1.0, -3.0)),
    ];
    boxes.extend((0..100).map(|trial| {
        let mut stream = Stream::of_trial(82, trial);
        Aabb::of_points([point(&mut stream, 9.0), point(&mut stream, 9.0)])
    }));
    boxes
}

/// Face by face, in f64.
fn exact_area(bounds: &Aabb) -> f32 {
    let side = bounds.max.as_dvec3() - bounds.min.as_dvec3();
    if side.min_element() < 0.0 {
        return 0.0;
    }
    let faces = (0..3).map(|axis| side[axis] * side[(axis + 1) % 3]);
    faces.map(|face| face + face).sum::<f64>() as f32
}

/// A ray that may or may not meet a box before its end.
#[derive(Debug)]
pub(crate) struct Question {
    ray: Ray,
    bounds: Aabb,
    t_max: f32,
}

#[test]
fn exercise_8_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "8.3",
        title: "Three slabs",
        section: "Three slabs",
        cases: questions,
        expected: exact_entry,
        agree: |_, expected, yours| {
            agree::options(expected, yours, |a, b| agree::close(*a, *b, 1e-4))
        },
        yours: |it| enter(&it.ray, &it.bounds, it.t_max),
        solution: |it| solutions::enter(&it.ray, &it.bounds, it.t_max),
        mistakes: mistakes::enter(),
    }
    .judge()
}

fn questions() -> Vec<Question> {
    let bounds = Aabb { min: Vec3::new(4.0, -7.0, 10.0), max: Vec3::new(5.0, -5.0, 13.0) };
    let ask = |origin: Vec3, direction: Vec3, t_max: f32| Question {
        ray: Ray { origin, direction },
        bounds,
        t_max,
    };
    let (at, far) = (Vec3::new(2.0, -3.0, 6.0), f32::INFINITY);
    let inside = bounds.center();
    let mut questions = vec![
        // The page's worked number, and the same from the other side.
        ask(Vec3::ZERO, at, far),
        ask(4.0 * at, -at, far),
        ask(Vec3::ZERO, Vec3::new(2.0, -3.0, 12.0), far),
        // Inside, behind, beyond.
        ask(inside, at, far),
        ask(Vec3::ZERO, -at, far),
        ask(Vec3::ZERO, at, 1.5),
        ask(Vec3::ZERO, at, 2.1),
    ];
    let random = (0..600).map(|trial| {
        let mut stream = Stream::of_trial(83, trial);
        let bounds = Aabb::of_points([point(&mut stream, 3.0), point(&mut stream, 3.0)]);
        let origin = point(&mut stream, 6.0);
        let target = bounds.center() + point(&mut stream, 2.0);
        let t_max = if trial.is_multiple_of(3) { stream.between(0.1, 2.0) } else { f32::INFINITY };
        Question { ray: Ray { origin, direction: target - origin }, bounds, t_max }
    });
    // Not those that f64 is needed for: which graze an edge, or end at the box.
    questions.extend(random.filter(is_clear));
    questions
}

fn is_clear(Question { ray, bounds, t_max }: &Question) -> bool {
    let [wide, narrow] = [1e-3, -1e-3].map(|margin| {
        let t_max = f64::from(*t_max) * (1.0 + margin);
        crossing(ray, bounds, margin).is_some_and(|[near, far]| near.max(0.0) <= far.min(t_max))
    });
    let thick = bounds.size().min_element() > 0.1;
    let slanted = ray.direction.abs().min_element() > 0.05;
    thick && slanted && wide == narrow
}

/// By cutting the ray with all six faces, in f64: the first crossing that lies on the box.
fn exact_entry(Question { ray, bounds, t_max }: &Question) -> Option<f32> {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
    let is_in = |point: DVec3, but: usize| {
        (0..3).all(|axis| axis == but || (min[axis] <= point[axis] && point[axis] <= max[axis]))
    };
    let cuts =
        (0..3).flat_map(|axis| [min, max].map(|face| (axis, (face[axis] - o[axis]) / d[axis])));
    let on_box = cuts.filter(|&(axis, t)| t >= 0.0 && is_in(o + t * d, axis));
    let first = on_box.map(|(_, t)| t).fold(f64::INFINITY, f64::min);
    // The fourth axis doesn't exist: no coordinate is left out.
    let first = if is_in(o, 3) { 0.0 } else { first };
    (first.is_finite() && first <= f64::from(*t_max)).then_some(first as f32)
}

/// A ray and a box, for a yes or no.
#[derive(Debug)]
pub(crate) struct Meeting {
    ray: Ray,
    bounds: Aabb,
}

#[test]
fn exercise_8_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "8.4",
        title: "Find the mistake: boxes without thickness",
        section: "Rays in the plane of a face",
        cases: meetings,
        expected: |it| verdict(&it.ray, &it.bounds, f64::INFINITY, 0.0) == Verdict::Met,
        agree: |_, expected, yours| expected == yours,
        yours: |it| meets(&it.ray, &it.bounds),
        solution: |it| solutions::meets(&it.ray, &it.bounds),
        mistakes: mistakes::meets(),
    }
    .judge()
}

fn meetings() -> Vec<Meeting> {
    let flat = Aabb { min: Vec3::new(1.0, 2.0, 7.0), max: Vec3::new(4.0, 8.0, 7.0) };
    let thick = Aabb { max: flat.max + Vec3::new(0.0, 0.0, 2.0), ..flat };
    let tiny = |bounds: Aabb| Aabb { min: bounds.min * SMALL, max: bounds.max * SMALL };
    let mut meetings = Vec::new();
    for (bounds, scale) in [(flat, 1.0), (thick, 1.0), (tiny(flat), SMALL), (tiny(thick), SMALL)] {
        let mut ask = |[x, y, z]: [f32; 3], direction: [f32; 3]| {
            let origin = scale * Vec3::new(x, y, z);
            meetings.push(Meeting { ray: Ray { origin, direction: direction.into() }, bounds });
        };
        // Through the middle, across and slanted; and beside it.
        ask([2.0, 4.0, 0.0], [0.0, 0.0, 1.0]);
        ask([0.0, 0.0, 0.0], [2.0, 4.0, 7.0]);
        ask([6.0, 4.0, 0.0], [0.0, 0.0, 1.0]);
        ask([2.0, 9.0, 0.0], [0.0, 0.0, 1.0]);
        // In the planes of faces, with zeros of either sign; and beside them.
        for zero in [0.0, -0.0] {
            for (y, along) in [(0.0, 1.0), (10.0, -1.0)] {
                for x in [0.0, 1.0, 2.0, 4.0, 5.0] {
                    for z in [6.0, 7.0, 8.0, 9.0, 9.5] {
                        ask([x, y, z], [zero, along, zero]);
                    }
                }
            }
        }
    }
    meetings
}

/// A power of two, so that what is in the plane of a face stays in it.
const SMALL: f32 = 1.0 / (1 << 24) as f32;

/// A ray's origin, and the box of a scene.
#[derive(Debug)]
pub(crate) struct Padding {
    origin: Vec3,
    scene: Aabb,
}

#[test]
fn exercise_8_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "8.5",
        title: "A pad with a unit",
        section: "A pad with a unit",
        cases: paddings,
        expected: exact_pad,
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-5),
        yours: |it| pad(it.origin, &it.scene),
        solution: |it| solutions::pad(it.origin, &it.scene),
        mistakes: mistakes::pad(),
    }
    .judge()
}

fn paddings() -> Vec<Padding> {
    let scene = Aabb { min: Vec3::new(4.0, -7.0, 10.0), max: Vec3::new(5.0, -5.0, 13.0) };
    let mut paddings: Vec<Padding> =
        [Vec3::ZERO, scene.center(), Vec3::new(1e3, 2.0, -3.0), Vec3::new(0.0, 90.0, 0.0)]
            .map(|origin| Padding { origin, scene })
            .into();
    paddings.extend((0..60).map(|trial| {
        let mut stream = Stream::of_trial(85, trial);
        let side = [1e-6, 1.0, 1e6][trial as usize % 3];
        let scene = Aabb::of_points([point(&mut stream, side), point(&mut stream, side)]);
        Padding { origin: point(&mut stream, 4.0 * side), scene }
    }));
    paddings
}

/// Corner by corner, in f64.
fn exact_pad(Padding { origin, scene }: &Padding) -> f32 {
    let corners = (0..8).map(|bits| {
        let coordinate =
            |axis: usize| if bits >> axis & 1 == 1 { scene.max } else { scene.min }[axis];
        Vec3::new(coordinate(0), coordinate(1), coordinate(2)).as_dvec3()
    });
    let distance = |corner: DVec3| (corner - origin.as_dvec3()).abs().max_element();
    (16.0 / f64::from(1 << 24) * corners.map(distance).fold(0.0, f64::max)) as f32
}
