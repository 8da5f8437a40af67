//! What is asked, and the right answers by other ways than the solutions'.

use common::sampler::Stream;
use glam::{DVec3, Vec3};
use partitions::exercises::{Nearest, Passed};

/// A coordinate on a grid's side.
#[derive(Debug)]
pub(crate) struct Coordinate {
    pub(crate) coordinate: f32,
    pub(crate) low: f32,
    pub(crate) high: f32,
    pub(crate) cells: i32,
}

/// None but the ends so near to a border that rounding could decide.
pub(crate) fn coordinates() -> Vec<Coordinate> {
    let side = |low: f32, high: f32, cells: i32, coordinates: [f32; 5]| {
        coordinates.map(|coordinate| Coordinate { coordinate, low, high, cells })
    };
    [
        side(0.0, 16.0, 8, [3.0, 9.5, 4.0, 0.0, 16.0]),
        side(-6.0, -2.0, 5, [-5.9, -3.0, -4.5, -6.0, -2.0]),
        side(1e6, 1e6 + 1.0, 64, [1e6 + 0.25, 1e6 + 0.9375, 1e6, 1e6 + 1.0, 1e6 + 0.125]),
        side(1e6, 1e6 + 1.0, 10, [1e6 + 0.5625, 1e6 + 0.1875, 1e6 + 0.9375, 1e6 + 1.0, 1e6]),
        side(100.0, 101.0, 3, [100.2, 100.5, 100.9, 101.0, 100.0]),
        side(0.0, 16.0, 8, [-0.5, -40.0, 16.5, 1e30, -1e30]),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// By counting the borders at or below it.
pub(crate) fn exact_cell(case: &Coordinate) -> i32 {
    let [coordinate, low, high] = [case.coordinate, case.low, case.high].map(f64::from);
    let border = |index: i32| low + (high - low) * f64::from(index) / f64::from(case.cells);
    (1..case.cells).filter(|&index| border(index) <= coordinate).count() as i32
}

/// A line in a grid.
#[derive(Debug)]
pub(crate) struct Line {
    pub(crate) origin: Vec3,
    pub(crate) direction: Vec3,
    pub(crate) cells: i32,
}

pub(crate) fn lines() -> Vec<Line> {
    let line = |origin: [f32; 3], direction: [f32; 3], cells| Line {
        origin: origin.into(),
        direction: direction.into(),
        cells,
    };
    let mut lines = vec![
        line([0.5, 0.25, 0.75], [1.0, 0.45, 0.2], 4),
        line([3.5, 3.25, 2.75], [-1.0, -0.6, -0.35], 4),
        line([0.5, 2.25, 1.5], [1.0, 0.0, -0.0], 5),
        line([4.5, 2.25, 1.5], [-1.0, 0.0, -0.0], 5),
        line([2.5, 2.25, 1.5], [0.0, -0.0, 1.0], 5),
        line([2.5, 0.25, 3.5], [-0.2, 0.9, -0.7], 6),
        line([0.5, 0.5, 0.25], [1.0, 0.1, 0.1], 1),
    ];
    lines.extend((0..60).map(|trial| {
        let mut stream = Stream::of_trial(92, trial);
        let mut vector = |low, high| Vec3::from([0, 1, 2].map(|_| stream.between(low, high)));
        Line { origin: vector(0.0, 7.0), direction: vector(-1.0, 1.0), cells: 7 }
    }));
    lines
}

/// By sorting all crossings with borders: between each and the next the line is in one cell, that of
/// the point halfway.
pub(crate) fn cells_by_middles(line: &Line) -> Vec<[i32; 3]> {
    let (origin, direction) = (line.origin.as_dvec3(), line.direction.as_dvec3());
    let mut crossings = vec![0.0];
    for axis in 0..3 {
        let to = |border: i32| (f64::from(border) - origin[axis]) / direction[axis];
        crossings.extend((0..=line.cells).map(to).filter(|t| *t > 0.0 && t.is_finite()));
    }
    crossings.sort_by(f64::total_cmp);
    let middles = crossings.windows(2).map(|pair| origin + direction * (pair[0] + pair[1]) / 2.0);
    let inside = |point: &DVec3| {
        point.cmpge(DVec3::ZERO).all() && point.cmplt(DVec3::splat(f64::from(line.cells))).all()
    };
    middles.filter(inside).map(|point| point.floor().to_array().map(|it| it as i32)).collect()
}

/// Cells on a ray's way, with the hits of what is in them.
pub(crate) fn ways() -> Vec<Vec<Passed>> {
    let cell = |leaves: f32, hits: &[(u32, f32)]| Passed { leaves, hits: hits.to_vec() };
    let mut ways = vec![
        // Nothing at all, and one hit where it is found.
        vec![],
        vec![cell(1.0, &[]), cell(2.0, &[(4, 1.5)]), cell(3.0, &[(5, 2.5)])],
        // The first hit that is found is behind one in the next cell.
        vec![cell(1.0, &[(7, 2.5)]), cell(2.0, &[(3, 1.25)]), cell(3.0, &[(7, 2.5)])],
        // It is the right one, but the next cell has to be looked into to know.
        vec![cell(1.0, &[(7, 1.5)]), cell(2.0, &[(7, 1.5), (8, 1.75)]), cell(3.0, &[(1, 2.5)])],
        // Two in a cell, the nearer one second.
        vec![cell(2.0, &[(1, 1.75), (2, 0.5)]), cell(4.0, &[(3, 3.0)])],
        // As near as one another, in one cell and on a border.
        vec![cell(2.0, &[(9, 1.5), (4, 1.5), (6, 1.5)])],
        vec![cell(2.0, &[(9, 2.0)]), cell(4.0, &[(5, 2.0)]), cell(5.0, &[(1, 4.5)])],
        vec![cell(2.0, &[(3, 2.0)]), cell(4.0, &[(5, 2.0)]), cell(5.0, &[(1, 4.5)])],
    ];
    ways.extend((0..60).map(|trial| way(&mut Stream::of_trial(93, trial))));
    ways
}

/// Triangles that reach from one cell into later ones, and are hit in one of these.
fn way(stream: &mut Stream) -> Vec<Passed> {
    let mut cells: Vec<Passed> =
        (1..6).map(|at| Passed { leaves: at as f32, hits: Vec::new() }).collect();
    for triangle in (0..4).rev() {
        let first = (stream.bits() % 5) as usize;
        let last = first + stream.bits() as usize % (5 - first);
        let t = first as f32 + (last - first + 1) as f32 * stream.uniform();
        for cell in &mut cells[first..=last] {
            cell.hits.push((triangle, t));
        }
    }
    cells
}

/// The least of all hits, and the first cell after which none can be less.
pub(crate) fn least_of_all(cells: &[Passed]) -> Nearest {
    let all = |cells: &[Passed]| -> Vec<(f32, u32)> {
        let mut all: Vec<_> =
            cells.iter().flat_map(|it| &it.hits).map(|&(triangle, t)| (t, triangle)).collect();
        all.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        all
    };
    let is_enough = |count: &usize| {
        let until = &cells[..*count];
        all(until).first().is_some_and(|(t, _)| *t < until[count - 1].leaves)
    };
    let count = (1..=cells.len()).find(is_enough).unwrap_or(cells.len());
    Nearest { hit: all(cells).first().map(|&(t, triangle)| (triangle, t)), cells: count }
}

/// A cell along one axis.
#[derive(Debug)]
pub(crate) struct Cell {
    pub(crate) low: f32,
    pub(crate) high: f32,
}

impl Cell {
    /// Whether `yours` is as good a middle as `expected`.
    pub(crate) fn is_middle(&self, expected: f32, yours: f32) -> bool {
        let width = f64::from(self.high) - f64::from(self.low);
        let spacing = f64::from(expected.next_up()) - f64::from(expected);
        let gap = (f64::from(expected) - f64::from(yours)).abs();
        (self.low < yours && yours < self.high && gap <= (1e-3 * width).max(spacing))
            || (expected.is_nan() && yours.is_nan())
            || expected == yours
    }
}

pub(crate) fn cells() -> Vec<Cell> {
    let after = |low: f32, steps: u32| Cell { low, high: f32::from_bits(low.to_bits() + steps) };
    vec![
        Cell { low: -3.0, high: 7.0 },
        Cell { low: 1e-9, high: 3e-9 },
        Cell { low: -2.0, high: -1.0 },
        after(1.0, 1),
        after(1.0, 2),
        after(1e6, 3),
        after(f32::from_bits(1), 1),
        Cell { low: 2e38, high: 3e38 },
        Cell { low: -3e38, high: -2.5e38 },
        Cell { low: -f32::MAX, high: f32::MAX },
        Cell { low: -3e38, high: 2e38 },
        Cell { low: 0.0, high: 1e-40 },
    ]
}

/// In f64, where nothing overflows; rounded to f32 it must still be between.
pub(crate) fn middle_in_f64(cell: &Cell) -> Option<f32> {
    let middle = ((f64::from(cell.low) + f64::from(cell.high)) / 2.0) as f32;
    let between = |it: &f32| cell.low < *it && *it < cell.high;
    Some(middle).filter(between).or(Some(cell.low.next_up()).filter(between))
}

/// A cell to be cut.
#[derive(Debug)]
pub(crate) struct Cut {
    pub(crate) size: Vec3,
    pub(crate) part: f32,
    pub(crate) below: u32,
    pub(crate) above: u32,
}

pub(crate) fn cuts() -> Vec<Cut> {
    let cut = |size: [f32; 3], part, below, above| Cut { size: size.into(), part, below, above };
    vec![
        cut([1.0, 2.0, 3.0], 0.5, 10, 10),
        cut([1.0, 2.0, 3.0], 0.25, 3, 17),
        cut([4.0, 1.0, 1.5], 0.25, 0, 12),
        cut([4.0, 1.0, 1.5], 0.9, 40, 2),
        cut([0.1, 30.0, 2.0], 0.3, 5, 7),
        cut([2.0, 2.0, 0.0], 0.75, 8, 8),
    ]
}

/// Face by face, in f64.
pub(crate) fn by_faces(cut: &Cut) -> f32 {
    let [x, y, z] = cut.size.as_dvec3().to_array();
    let part = f64::from(cut.part);
    let surface = |x: f64| [[x, y], [y, z], [z, x]].map(|[a, b]| a * b + b * a).iter().sum::<f64>();
    let probability = |x: f64| surface(x) / surface(cut.size.x.into());
    let below = probability(part * x) * f64::from(cut.below);
    (below + probability((1.0 - part) * x) * f64::from(cut.above)) as f32
}
