//! The exercises of chapter 2: one test each.

mod mistakes;
mod solutions;

use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, Mistake, agree};
use common::sampler::Stream;
use glam::{DVec3, Vec2, Vec3};
use triangles::exercises;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

/// Two points in the plane across the ray.
#[derive(Debug)]
pub(crate) struct Edge {
    pub(crate) p: Vec2,
    pub(crate) q: Vec2,
}

/// A ray and a triangle.
#[derive(Debug)]
pub(crate) struct Question {
    pub(crate) origin: Vec3,
    pub(crate) direction: Vec3,
    pub(crate) corners: [Vec3; 3],
}

/// Normals at three corners, the weights of a point between them, and the triangle's own normal.
#[derive(Debug)]
pub(crate) struct Blend {
    pub(crate) normals: [Vec3; 3],
    pub(crate) weights: Vec3,
    pub(crate) geometric: Vec3,
}

fn point(stream: &mut Stream) -> Vec3 {
    let x = stream.between(-1.0, 1.0);
    let y = stream.between(-2.0, 2.0);
    Vec3::new(x, y, stream.between(-3.0, 3.0))
}

#[test]
fn exercise_2_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "2.1",
        title: "The edge function",
        section: "The edge function",
        cases: edges,
        expected: |Edge { p, q }| {
            let whole = |it: f32| i128::from(it as i64);
            (whole(p.x) * whole(q.y) - whole(p.y) * whole(q.x)) as f64
        },
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-15),
        yours: |case| exercises::edge_function(case.p, case.q),
        solution: solutions::edge_function,
        mistakes: vec![
            Mistake {
                name: "f32 products",
                diagnosis: "You multiplied in f32. Each product is rounded to 24 bits, and where \
                    the two nearly cancel only rounding errors are left: see \"The edge function\". \
                    Make each coordinate an f64 first: f64::from(p.x).",
                answer: mistakes::edge_in_f32,
            },
            Mistake {
                name: "the other side",
                diagnosis: "Your sign is that of the other side: you took p.y q.x - p.x q.y. \
                    Check with p = (1, 0) and q = (0, 1), for which the origin is to the left.",
                answer: mistakes::edge_turned,
            },
            Mistake {
                name: "a sum for a difference",
                diagnosis: "You added the two products. The area is their difference: see \"The \
                    edge function\".",
                answer: mistakes::edge_sum,
            },
            Mistake {
                name: "the dot product",
                diagnosis: "p.x q.x + p.y q.y is the dot product: it says whether the angle \
                    between p and q is acute, not which way it turns.",
                answer: mistakes::edge_dot,
            },
        ],
    }
    .judge()
}

/// Small numbers first; then whole numbers of 24 bits, half of them nearly in line with the origin.
fn edges() -> Vec<Edge> {
    let mut cases = vec![
        Edge { p: Vec2::new(1.0, 0.0), q: Vec2::new(0.0, 1.0) },
        Edge { p: Vec2::new(2.0, 3.0), q: Vec2::new(-5.0, 1.0) },
    ];
    for trial in 0..200 {
        let mut stream = Stream::of_trial(21, trial);
        let mut digits = || (stream.bits() >> 8) as f32;
        let p = Vec2::new(digits(), digits());
        let nearly = Vec2::new((p.x - 1.0).max(0.0), (p.y - 1.0).max(0.0));
        let q = if trial % 2 == 0 { Vec2::new(digits(), -digits()) } else { nearly };
        cases.push(Edge { p, q });
    }
    cases
}

#[test]
fn exercise_2_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "2.2",
        title: "Möller and Trumbore without epsilon",
        section: "Three unknowns",
        cases: questions,
        expected: distance,
        agree: |_, expected, yours| {
            agree::options(expected, yours, |expected, yours| agree::close(*expected, *yours, 1e-3))
        },
        yours: |case| exercises::intersect(case.origin, case.direction, case.corners),
        solution: solutions::intersect,
        mistakes: vec![
            Mistake {
                name: "an absolute epsilon",
                diagnosis: "You reject a determinant below a fixed number. The determinant shrinks \
                    with the triangle's area, so that small triangles vanish: see \"Where it \
                    breaks\", TR-01. Reject only a determinant of 0.",
                answer: mistakes::intersect_epsilon,
            },
            Mistake {
                name: "one-sided",
                diagnosis: "You reject a negative determinant. That is back-face culling: the \
                    triangle disappears when it is seen from its other side.",
                answer: mistakes::intersect_culled,
            },
            Mistake {
                name: "the parallelogram",
                diagnosis: "You ask whether v and w lie between 0 and 1, but not whether their sum \
                    is at most 1. That hits a parallelogram twice as large as the triangle: the \
                    first corner's weight, 1 - v - w, must not be negative either.",
                answer: mistakes::intersect_parallelogram,
            },
            Mistake {
                name: "behind the eye",
                diagnosis: "You accept a negative t. That point lies behind the ray's origin.",
                answer: mistakes::intersect_behind,
            },
            Mistake {
                name: "not divided",
                diagnosis: "Your t is not divided by the determinant: see Cramer's rule in \"Three \
                    unknowns\".",
                answer: mistakes::intersect_undivided,
            },
        ],
    }
    .judge()
}

/// Triangles of all sizes, and rays at points clearly inside, clearly outside, or behind.
fn questions() -> Vec<Question> {
    let corners = [Vec3::new(0.0, 0.0, 1.0), Vec3::new(4.0, 0.0, 1.0), Vec3::new(0.0, 6.0, 1.0)];
    let origin = Vec3::new(1.0, 1.0, 5.0);
    let mut cases = vec![Question { origin, direction: Vec3::new(0.0, 0.0, -2.0), corners }];
    // Inside, beyond the long side, beyond a short one, and behind.
    let targets = [(0.3, 0.4, 1.0), (0.8, 0.7, 1.0), (-0.4, 0.6, 1.0), (0.3, 0.3, -1.0)];
    for trial in 0..240 {
        let mut stream = Stream::of_trial(22, trial);
        let shape = [point(&mut stream), point(&mut stream), point(&mut stream)];
        let (v, w, ahead) = targets[(trial % 4) as usize];
        let target = shape[0] + v * (shape[1] - shape[0]) + w * (shape[2] - shape[0]);
        let normal = (shape[1] - shape[0]).cross(shape[2] - shape[0]);
        let side = if trial % 8 < 4 { normal } else { -normal };
        let from = target + 0.7 * side + 0.2 * point(&mut stream).cross(normal);
        let scale = [1.0, 1e-3, 1e-9][(trial / 8 % 3) as usize];
        let direction = ahead * (target - from);
        if normal.length() > 0.5 {
            let corners = shape.map(|corner| scale * corner);
            cases.push(Question { origin: scale * from, direction, corners });
        }
    }
    cases
}

/// The plane's distance by the normal, and the sides of the hit point, in f64.
fn distance(case: &Question) -> Option<f32> {
    let [a, b, c] = case.corners.map(|corner| corner.as_dvec3());
    let (origin, direction) = (case.origin.as_dvec3(), case.direction.as_dvec3());
    let normal = (b - a).cross(c - a);
    let t = (a - origin).dot(normal) / direction.dot(normal);
    let hit = origin + t * direction;
    let left = |p: DVec3, q: DVec3| (q - p).cross(hit - p).dot(normal) >= 0.0;
    (t > 0.0 && left(a, b) && left(b, c) && left(c, a)).then_some(t as f32)
}

#[test]
fn exercise_2_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "2.3",
        title: "Smooth normals",
        section: "Smooth normals",
        cases: blends,
        expected: |case| {
            let [a, b, c] = case.normals.map(|normal| normal.as_dvec3());
            let [u, v, w] = case.weights.as_dvec3().to_array();
            let mean = u * a + v * b + w * c;
            if mean.length() < 1e-4 { case.geometric } else { mean.normalize().as_vec3() }
        },
        agree: |_, expected, yours| agree::close_vectors(*expected, *yours, 1e-5),
        yours: |case| exercises::smooth_normal(case.normals, case.weights, case.geometric),
        solution: solutions::smooth_normal,
        mistakes: vec![
            Mistake {
                name: "not of length 1",
                diagnosis: "Your normal is shorter than 1. The mean of unit vectors that differ is \
                    shorter than they are: it has to be normalized.",
                answer: mistakes::blend_short,
            },
            Mistake {
                name: "rotated weights",
                diagnosis: "Your weights belong to other corners. Möller and Trumbore's two \
                    numbers are the weights of the second and third corner; here `weights` already \
                    has all three, in the order of the corners.",
                answer: mistakes::blend_rotated,
            },
            Mistake {
                name: "no way out",
                diagnosis: "Where the normals cancel you normalize a vector of length 0, and get \
                    NaN. Give the triangle's own normal there: see \"Smooth normals\".",
                answer: mistakes::blend_unguarded,
            },
            Mistake {
                name: "flat",
                diagnosis: "You always give the triangle's own normal, so that the facets show.",
                answer: mistakes::blend_flat,
            },
        ],
    }
    .judge()
}

/// Random normals and weights; every tenth has normals that cancel.
fn blends() -> Vec<Blend> {
    let unit = |stream: &mut Stream| (point(stream) + 0.1).normalize();
    let case = |trial| {
        let mut stream = Stream::of_trial(23, trial);
        let normals = [unit(&mut stream), unit(&mut stream), unit(&mut stream)];
        let spread = Vec3::new(stream.uniform(), stream.uniform(), stream.uniform()) + 0.05;
        let (weights, geometric) = (spread / spread.element_sum(), unit(&mut stream));
        match trial % 10 {
            9 => {
                let normals = [normals[0], -normals[0], normals[2]];
                Blend { normals, weights: Vec3::new(0.5, 0.5, 0.0), geometric }
            }
            _ => Blend { normals, weights, geometric },
        }
    };
    (0..100).map(case).collect()
}

#[test]
fn exercise_2_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "2.4",
        title: "Triangles without area",
        section: "Triangles without area",
        cases: thin_and_thick,
        expected: |(_, has_area)| *has_area,
        agree: |_, expected, yours| expected == yours,
        yours: |(corners, _)| exercises::has_area(*corners),
        solution: solutions::has_area,
        mistakes: vec![
            Mistake {
                name: "the squared length",
                diagnosis: "The square of the cross product's length is of the fourth order in the \
                    triangle's size: below 10^-12 it is 0 in f32, and above 10^10 infinite. See \
                    \"Triangles without area\".",
                answer: mistakes::area_squared,
            },
            Mistake {
                name: "the squared length above 0",
                diagnosis: "The square of the cross product's length is of the fourth order in the \
                    triangle's size: below 10^-12 it is 0 in f32. See \"Triangles without area\".",
                answer: mistakes::area_squared_above,
            },
            Mistake {
                name: "components in f32",
                diagnosis: "You ask the components of the cross product, which is better by a \
                    square root. But they are products of two lengths, still in f32: below 10^-23 \
                    they are 0. An f64 holds any product of two f32.",
                answer: mistakes::area_components,
            },
            Mistake {
                name: "components in f32 above 0",
                diagnosis: "You ask the components of the cross product, which is better by a \
                    square root. But they are products of two lengths, still in f32: below 10^-23 \
                    they are 0. An f64 holds any product of two f32.",
                answer: mistakes::area_components_above,
            },
            Mistake {
                name: "components in f32 without their sign",
                diagnosis: "You ask whether a component of the cross product is above 0. One below \
                    0 is as good: the triangle faces the other way. And the products are still in \
                    f32: below 10^-23 they are 0. An f64 holds any product of two f32.",
                answer: mistakes::area_positive,
            },
            Mistake {
                name: "only components above 0",
                diagnosis: "You ask whether a component of the cross product is above 0. One below \
                    0 is as good: the triangle faces the other way.",
                answer: mistakes::area_positive_in_f64,
            },
            Mistake {
                name: "an absolute epsilon",
                diagnosis: "You compare with a fixed number. No number is small for all \
                    triangles: scale the scene, and the answer changes.",
                answer: mistakes::area_epsilon,
            },
            Mistake {
                name: "only equal corners",
                diagnosis: "You ask whether two corners coincide. Three different points in line \
                    have no area either.",
                answer: mistakes::area_corners,
            },
        ],
    }
    .judge()
}

/// Triangles of many sizes, a third of them with their corners exactly in line. The truth is known
/// from how they are made.
fn thin_and_thick() -> Vec<([Vec3; 3], bool)> {
    let case = |trial: u64| {
        let mut stream = Stream::of_trial(24, trial);
        // Powers of two from 2^-100 to 2^100, mild ones first: scaling by them is exact.
        let power = (trial as i32 % 11 - 5) * (trial as i32 / 11);
        let scale = f32::from_bits(((127 + power) as u32) << 23);
        let start = (20.0 * point(&mut stream)).round();
        let step = (20.0 * point(&mut stream)).round() + Vec3::new(0.0, 0.0, 100.0);
        let in_line = trial.is_multiple_of(3);
        // To both sides, so that every sign of the cross product's components comes up.
        let right = if trial.is_multiple_of(2) { 7.0 } else { -7.0 };
        let aside = if in_line { Vec3::ZERO } else { Vec3::new(right, 30.0, 0.0) };
        let corners = [start, start + step, start + 4.0 * step + aside];
        (corners.map(|corner| scale * corner), !in_line)
    };
    (0..220).map(case).collect()
}

#[test]
fn exercise_2_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "2.5",
        title: "Closed meshes",
        section: "Watertight",
        cases: meshes,
        expected: |(_, closed)| *closed,
        agree: |_, expected, yours| expected == yours,
        yours: |(triangles, _)| exercises::is_closed(triangles),
        solution: solutions::is_closed,
        mistakes: vec![
            Mistake {
                name: "directions ignored",
                diagnosis: "You count how many triangles share an edge and not which way they run \
                    along it. A triangle that is turned over goes unnoticed, though its outside is \
                    in: see \"Watertight\".",
                answer: mistakes::closed_undirected,
            },
            Mistake {
                name: "at least one partner",
                diagnosis: "You only ask whether there is a partner. With two partners for one \
                    edge, three triangles meet there, and one of them is a wall that nothing \
                    continues.",
                answer: mistakes::closed_loosely,
            },
            Mistake {
                name: "edges that cancel",
                diagnosis: "You let edges cancel: an edge used twice each way is balanced, but it \
                    has more than one partner. The listing in \"Watertight\" asks for the balance; \
                    here each edge may be used once each way.",
                answer: mistakes::closed_by_balance,
            },
            Mistake {
                name: "Euler's formula",
                diagnosis: "You count: three halves as many edges as triangles. That is true of \
                    every closed mesh, but of others too.",
                answer: mistakes::closed_by_count,
            },
        ],
    }
    .judge()
}

/// Closed meshes, and such with a hole, a turned face, or a face too many.
fn meshes() -> Vec<(Vec<[u32; 3]>, bool)> {
    let tetrahedron = vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let mut turned = tetrahedron.clone();
    turned[2] = [1, 2, 3];
    let with = |more: &[[u32; 3]]| [&tetrahedron, more].concat();
    let apart = with(&[[4, 5, 6], [4, 7, 5], [5, 7, 6], [6, 7, 4]]);
    let sphere = triangles::bumpy::sphere(200).triangles;
    let holed = sphere[1..].to_vec();
    let torn = sphere[2..].to_vec();
    vec![
        (tetrahedron.clone(), true),
        (tetrahedron[..3].to_vec(), false),
        (turned, false),
        (with(&[[0, 1, 4]]), false),
        (with(&[[0, 1, 2]]), false),
        (with(&[[0, 1, 4], [1, 0, 4]]), false),
        (apart, true),
        (pinwheel(), false),
        (sphere, true),
        (holed, false),
        (torn, false),
        (vec![], true),
    ]
}

/// Four tetrahedra around one edge, two of them open: as many edges as a closed mesh would have.
fn pinwheel() -> Vec<[u32; 3]> {
    let tetrahedron = |a: u32| {
        let b = a + 1;
        [[0, 1, a], [0, b, 1], [a, b, 0], [1, b, a]]
    };
    let closed = [2, 4].map(tetrahedron).concat();
    let open = [6, 8].map(|a| tetrahedron(a)[..3].to_vec()).concat();
    [closed, open].concat()
}
