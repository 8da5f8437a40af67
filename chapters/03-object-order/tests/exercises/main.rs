//! The exercises of chapter 3, judged.

mod mistakes;
mod solutions;

use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, agree};
use common::film::{Color, Film};
use common::sampler::Stream;
use glam::{DMat3, DVec3};
use object_order::exercises::{color_of, draw, near_point, owns, value_between};
use object_order::fixed::Fixed;
use object_order::project::FilmPoint;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

/// An edge and a sample, in 1/256 pixel.
#[derive(Debug)]
pub(crate) struct Edge {
    from: Fixed,
    to: Fixed,
    sample: Fixed,
}

#[test]
fn exercise_3_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "3.1",
        title: "Whose sample is it?",
        section: "One sample, one owner",
        cases: edges,
        expected: exact_owner,
        agree: |_, expected, yours| expected == yours,
        yours: |edge| owns(edge.from, edge.to, edge.sample),
        solution: |edge| solutions::owns(edge.from, edge.to, edge.sample),
        mistakes: mistakes::owns(),
    }
    .judge()
}

fn edges() -> Vec<Edge> {
    let at = |[x, y]: [i32; 2]| Fixed { x, y };
    let edge = |from, to, sample| Edge { from: at(from), to: at(to), sample: at(sample) };
    let mut edges = vec![
        // Clear of the edge, on either side.
        edge([256, 256], [1792, 512], [768, 768]),
        edge([256, 256], [1792, 512], [768, 128]),
        // On it: a left, a right, a top and a bottom edge, and two slanted ones.
        edge([512, 1024], [512, 256], [512, 700]),
        edge([512, 256], [512, 1024], [512, 700]),
        edge([256, 768], [1280, 768], [600, 768]),
        edge([1280, 768], [256, 768], [600, 768]),
        edge([256, 1280], [768, 256], [512, 768]),
        edge([768, 256], [256, 1280], [512, 768]),
        // Far away: 2^22 pixels.
        edge([-(1 << 30), 1 << 30], [1 << 30, -(1 << 30) + 512], [1000, 1000]),
        edge([1 << 30, -(1 << 29)], [-(1 << 30), 1 << 29], [77, 5]),
    ];
    let random = (0..200).map(|trial| {
        let mut stream = Stream::of_trial(31, trial);
        let mut coordinate = || (stream.bits() % 4096) as i32;
        let mut point = || Fixed { x: coordinate(), y: coordinate() };
        Edge { from: point(), to: point(), sample: point() }
    });
    edges.extend(random);
    edges
}

/// By the angle at `from`, in exact whole numbers: the sign of the area, and then the rule.
fn exact_owner(Edge { from, to, sample }: &Edge) -> bool {
    let rows = [from, to, sample].map(|point| [1, i128::from(point.x), i128::from(point.y)]);
    let [[_, ax, ay], [_, bx, by], [_, cx, cy]] = rows;
    let determinant = bx * cy - by * cx - ax * cy + ay * cx + ax * by - ay * bx;
    match determinant.signum() {
        0 => by < ay || (by == ay && bx > ax),
        sign => sign > 0,
    }
}

/// An edge of the scene, and where on the film a sample lies along it.
#[derive(Debug)]
pub(crate) struct Stretch {
    depths: [f64; 2],
    values: [f64; 2],
    share: f64,
}

#[test]
fn exercise_3_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "3.2",
        title: "Half way is not half way",
        section: "Depth between the corners",
        cases: stretches,
        expected: seen_value,
        agree: |_, expected, yours| agree::within(*expected, *yours, 1e-9),
        yours: |it| value_between(it.depths, it.values, it.share),
        solution: |it| solutions::value_between(it.depths, it.values, it.share),
        mistakes: mistakes::value_between(),
    }
    .judge()
}

fn stretches() -> Vec<Stretch> {
    let mut stretches = vec![
        Stretch { depths: [1.0, 3.0], values: [0.0, 1.0], share: 0.5 },
        Stretch { depths: [2.0, 2.0], values: [5.0, 7.0], share: 0.25 },
        Stretch { depths: [1.0, 8.0], values: [-3.0, 4.0], share: 0.0 },
    ];
    let random = (0..100).map(|trial| {
        let mut stream = Stream::of_trial(32, trial);
        let mut number = |low, high| f64::from(stream.between(low, high));
        Stretch {
            depths: [number(0.5, 9.0), number(0.5, 9.0)],
            values: [number(-2.0, 2.0), number(-2.0, 2.0)],
            share: number(0.0, 1.0),
        }
    });
    stretches.extend(random);
    stretches
}

/// By geometry: the ends at film places 0 and 1, and the ray through the sample cut with the edge.
fn seen_value(Stretch { depths: [near, far], values: [a, b], share }: &Stretch) -> f64 {
    // The ends are (0, near) and (far, far) in the plane of x and depth; the ray is x = share * w.
    // At `along` of the way in the scene: far * along = share * (near + (far - near) * along).
    let along = share * near / (far - share * (far - near));
    a + along * (b - a)
}

/// An edge that crosses the near plane.
#[derive(Debug)]
pub(crate) struct Cut {
    a: FilmPoint,
    b: FilmPoint,
    near: f64,
}

impl Cut {
    /// The cut as both triangles at the edge ask for it.
    fn both(&self, cut: impl Fn(FilmPoint, FilmPoint, f64) -> FilmPoint) -> [FilmPoint; 2] {
        [cut(self.a, self.b, self.near), cut(self.b, self.a, self.near)]
    }
}

#[test]
fn exercise_3_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "3.3",
        title: "Find the mistake",
        section: "Cut, then divide",
        cases: cuts,
        expected: bisected,
        agree: same_cut,
        yours: |cut| cut.both(near_point),
        solution: |cut| cut.both(solutions::near_point),
        mistakes: mistakes::near_point(),
    }
    .judge()
}

fn cuts() -> Vec<Cut> {
    let point = |x, y, w| FilmPoint { x, y, w };
    let mut cuts = vec![
        Cut { a: point(2.0, 0.0, 1.25), b: point(4.0, 8.0, -0.75), near: 0.25 },
        Cut { a: point(30.0, -6.0, 0.5), b: point(10.0, 2.0, 2.5), near: 1.0 },
    ];
    let random = (0..100).map(|trial| {
        let mut stream = Stream::of_trial(33, trial);
        let mut number = |low, high| f64::from(stream.between(low, high));
        let near = number(0.05, 0.4);
        let a = point(number(-900.0, 900.0), number(-700.0, 700.0), number(0.5, 9.0));
        let b = point(number(-900.0, 900.0), number(-700.0, 700.0), number(-5.0, 0.04));
        if trial.is_multiple_of(2) { Cut { a, b, near } } else { Cut { a: b, b: a, near } }
    });
    cuts.extend(random);
    cuts
}

/// By halving the edge until nothing is left of it.
fn bisected(cut: &Cut) -> [FilmPoint; 2] {
    let (mut inner, mut outer) = (cut.a.vector(), cut.b.vector());
    if inner.z < outer.z {
        (inner, outer) = (outer, inner);
    }
    for _ in 0..80 {
        let middle = (inner + outer) / 2.0;
        *(if middle.z >= cut.near { &mut inner } else { &mut outer }) = middle;
    }
    [inner.into(), inner.into()]
}

/// Whether both answers are right, and the same to the last bit when they should be.
fn same_cut(_: &Cut, expected: &[FilmPoint; 2], yours: &[FilmPoint; 2]) -> bool {
    let close = |(one, other): (&FilmPoint, &FilmPoint)| {
        let pairs = one.vector().to_array().into_iter().zip(other.vector().to_array());
        pairs.into_iter().all(|(one, other)| agree::within(one, other, 1e-9))
    };
    let alike = |[first, second]: &[FilmPoint; 2]| first == second;
    expected.iter().zip(yours).all(close) && alike(expected) == alike(yours)
}

/// Triangles to be drawn.
#[derive(Clone, Debug)]
pub(crate) struct Draw {
    triangles: Vec<[FilmPoint; 3]>,
    width: u32,
    height: u32,
}

#[test]
fn exercise_3_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "3.4",
        title: "A rasterizer of your own",
        section: "The z-buffer",
        cases: drawings,
        expected: ray_cast,
        agree: |_, expected, yours| agree::films(expected, yours, 1e-6),
        yours: |case| draw(&case.triangles, case.width, case.height),
        solution: |case| solutions::draw(&case.triangles, case.width, case.height),
        mistakes: mistakes::draw(),
    }
    .judge_picture()
}

fn drawings() -> Vec<Draw> {
    // Film coordinates and depth; the samples lie between the grid's lines.
    let corner = |[x, y, w]: [f64; 3]| FilmPoint { x: (x + 0.25) * w, y: (y + 0.375) * w, w };
    let draw = |triangles: &[[[f64; 3]; 3]]| Draw {
        triangles: triangles.iter().map(|corners| corners.map(corner)).collect(),
        width: 96,
        height: 64,
    };
    vec![
        draw(&[[[10.0, 8.0, 4.0], [85.0, 21.0, 4.0], [30.0, 57.0, 4.0]]]),
        // The near one first, and the second the other way round.
        draw(&[
            [[12.0, 10.0, 2.0], [80.0, 30.0, 2.0], [25.0, 60.0, 2.0]],
            [[90.0, 5.0, 6.0], [5.0, 30.0, 6.0], [70.0, 62.0, 6.0]],
        ]),
        // Three that pass through each other.
        draw(&[
            [[5.0, 7.0, 1.0], [91.0, 29.0, 9.0], [8.0, 59.0, 1.5]],
            [[90.0, 4.0, 1.0], [6.0, 33.0, 12.0], [88.0, 61.0, 2.0]],
            [[47.0, 2.0, 7.0], [77.0, 63.0, 1.1], [15.0, 61.0, 1.3]],
        ]),
        // The same one twice: equally near everywhere.
        draw(&[
            [[10.0, 50.0, 3.0], [60.0, 9.0, 5.0], [88.0, 40.0, 2.0]],
            [[10.0, 50.0, 3.0], [60.0, 9.0, 5.0], [88.0, 40.0, 2.0]],
        ]),
    ]
}

/// A ray for each pixel, and for each triangle the three weights that a 3x3 system gives.
fn ray_cast(case: &Draw) -> Film {
    let inverses: Vec<DMat3> = case
        .triangles
        .iter()
        .map(|[a, b, c]| DMat3::from_cols(a.vector(), b.vector(), c.vector()).inverse())
        .collect();
    Film::from_fn(case.width, case.height, |x, y| {
        let ray = DVec3::new(f64::from(x) + 0.5, f64::from(y) + 0.5, 1.0);
        let nearness = |inverse: &DMat3| {
            let weights = *inverse * ray;
            if weights.min_element() >= 0.0 { weights.element_sum() } else { 0.0 }
        };
        let best = inverses
            .iter()
            .map(nearness)
            .enumerate()
            .fold((0, 0.0), |best, next| if next.1 > best.1 { next } else { best });
        if best.1 > 0.0 { color_of(best.0) } else { Color::ZERO }
    })
}
