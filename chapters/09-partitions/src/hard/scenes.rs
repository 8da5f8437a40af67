//! Small scenes that are hard to arrange, each with every structure over it.

use std::sync::LazyLock;

use common::sampler::Stream;
use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::brute::Found;
use triangles::bumpy;

use crate::accelerator::Accelerator;
use crate::bsp::BspTree;
use crate::grid::Grid;
use crate::kd::{KdTree, Split};
use crate::octree::Octree;
use crate::scan::Scan;

/// A triangle's corners.
pub type Corners = [Vec3; 3];

/// Triangles, and all structures over them.
pub struct Scene {
    /// The triangles, in their order.
    pub triangles: Vec<Corners>,
    /// The linear scan, which is the reference.
    pub scan: Scan,
    pub(crate) grid: Grid,
    pub(crate) octree: Octree,
    pub(crate) median: KdTree,
    pub(crate) sah: KdTree,
    pub(crate) bsp: BspTree,
}

impl Scene {
    /// The scene of these triangles.
    pub fn new(triangles: Vec<Corners>) -> Self {
        Self {
            scan: Scan::build(triangles.clone()),
            grid: Grid::build(triangles.clone()),
            octree: Octree::build(triangles.clone()),
            median: KdTree::with_split(&triangles, Split::Median),
            sah: KdTree::with_split(&triangles, Split::Sah),
            bsp: BspTree::build(triangles.clone()),
            triangles,
        }
    }

    /// What the structure with this number says.
    pub(crate) fn answer(&self, structure: u64, ray: &Ray, t_max: f32) -> Answer {
        match structure {
            GRID => Answer::of(&self.grid, ray, t_max),
            OCTREE => Answer::of(&self.octree, ray, t_max),
            MEDIAN => Answer::of(&self.median, ray, t_max),
            SAH => Answer::of(&self.sah, ray, t_max),
            _ => Answer::of(&self.bsp, ray, t_max),
        }
    }
}

/// How many structures there are, and their numbers.
pub(crate) const STRUCTURES: u64 = 5;
const GRID: u64 = 0;
const OCTREE: u64 = 1;
pub(crate) const MEDIAN: u64 = 2;
pub(crate) const SAH: u64 = 3;
pub(crate) const BSP: u64 = 4;

/// What a structure says to a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    nearest: Option<Found>,
    is_hit: bool,
}

impl Answer {
    /// Its answer, with hits below `t_max`.
    pub fn of(accelerator: &impl Accelerator, ray: &Ray, t_max: f32) -> Self {
        let nearest = accelerator.nearest(ray, t_max, &mut Off);
        Self { nearest, is_hit: accelerator.is_hit(ray, t_max, &mut Off) }
    }

    /// Whether it is this answer, to the bit.
    pub fn is(&self, expected: Option<Found>) -> bool {
        bits(self.nearest) == bits(expected) && self.is_hit == expected.is_some()
    }
}

/// All that was found, bit by bit.
pub fn bits(found: Option<Found>) -> Option<(usize, [u32; 4])> {
    found.map(|Found { hit, index }| {
        let [u, v, w] = hit.barycentric.to_array();
        (index, [hit.t, u, v, w].map(f32::to_bits))
    })
}

/// The scenes that all structures are compared on.
pub static SCENES: LazyLock<Vec<Scene>> = LazyLock::new(|| {
    let sphere = |offset: Vec3| moved(bumpy::sphere(96).all_corners(), offset);
    let far = Vec3::new(148_376.0, 1_234.0, -223_423.0);
    let scenes = [
        soup(60),
        sphere(Vec3::ZERO),
        lattice(),
        sheet(),
        sphere(0.004 * far),
        sphere(0.3 * far),
        copies(),
        mixed_sizes(),
        progression(),
        vec![[Vec3::new(1.0, 2.0, 3.0), Vec3::new(5.0, 2.5, 1.0), Vec3::new(2.0, 7.0, 4.0)]],
        with_garbage(sphere(Vec3::ZERO)),
        scaled(sphere(Vec3::ZERO), 1e-30),
        scaled(soup(40), 1e18),
    ];
    scenes.into_iter().map(Scene::new).collect()
});

fn moved(triangles: Vec<Corners>, offset: Vec3) -> Vec<Corners> {
    triangles.into_iter().map(|corners| corners.map(|corner| corner + offset)).collect()
}

fn scaled(triangles: Vec<Corners>, factor: f32) -> Vec<Corners> {
    triangles.into_iter().map(|corners| corners.map(|corner| factor * corner)).collect()
}

/// A point of a lopsided box.
pub(crate) fn point(stream: &mut Stream) -> Vec3 {
    let x = stream.between(-1.0, 1.0);
    let y = stream.between(-2.0, 2.0);
    Vec3::new(x, y, stream.between(-3.0, 3.0))
}

/// Triangles anywhere, through one another.
pub fn soup(count: u64) -> Vec<Corners> {
    let triangle = |trial| {
        let mut stream = Stream::of_trial(901, trial);
        let middle = point(&mut stream);
        [0, 1, 2].map(|_| middle + 0.4 * point(&mut stream))
    };
    (0..count).map(triangle).collect()
}

/// The walls between the cubes of a lattice with whole coordinates: they lie where structures like
/// to cut, and meet at corners of cells.
fn lattice() -> Vec<Corners> {
    let mut triangles = Vec::new();
    for (across, up) in [(Vec3::X, Vec3::Y), (Vec3::Y, Vec3::Z), (Vec3::Z, Vec3::X)] {
        let along = across.cross(up);
        for (layer, row, column) in
            (0..3).flat_map(|i| (0..2).flat_map(move |j| [(i, j, 0), (i, j, 1)]))
        {
            let corner = layer as f32 * along + row as f32 * up + column as f32 * across;
            triangles.push([corner, corner + across, corner + across + up]);
            triangles.push([corner, corner + across + up, corner + up]);
        }
    }
    triangles
}

/// A flat sheet across z, without any thickness.
fn sheet() -> Vec<Corners> {
    let squares = (0..6).flat_map(|row| (0..5).map(move |column| (row as f32, column as f32)));
    let corner = |(row, column): (f32, f32)| Vec3::new(0.7 * column, 1.3 * row, 2.0);
    squares
        .map(|at| {
            [
                corner(at),
                corner(at) + Vec3::new(0.7, 0.0, 0.0),
                corner(at) + Vec3::new(0.0, 1.3, 0.0),
            ]
        })
        .collect()
}

/// The same triangles again and again, in another order.
fn copies() -> Vec<Corners> {
    let some = soup(7);
    (0..63).map(|number| some[number * 5 % 7]).collect()
}

/// From a thousandth to a thousand.
fn mixed_sizes() -> Vec<Corners> {
    let resized = |(number, corners): (usize, Corners)| {
        let factor = [1e-3, 0.1, 1.0, 30.0, 1e3][number % 5];
        let middle = corners[0];
        corners.map(|corner| middle + factor * (corner - middle))
    };
    soup(50).into_iter().enumerate().map(resized).collect()
}

/// Each half as far from the origin, and half as large, as the one before (hard case AC-04).
pub(crate) fn progression() -> Vec<Corners> {
    let at = |exponent: u32| {
        let size = f32::from_bits((127 + 20 - exponent) << 23);
        [Vec3::new(1.0, 0.1, 0.0), Vec3::new(1.9, 0.0, 0.3), Vec3::new(1.2, 0.8, 0.1)]
            .map(|corner| size * corner)
    };
    (0..120).map(at).collect()
}

/// Before each of these another triangle with corners of any bits at all, one of which isn't finite
/// (hard case AC-05).
pub fn with_garbage(good: Vec<Corners>) -> Vec<Corners> {
    const WORST: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let broken = |trial: usize| {
        let mut stream = Stream::of_trial(905, trial as u64);
        let mut any = || Vec3::from([0, 1, 2].map(|_| f32::from_bits(stream.bits())));
        let mut corners = [any(), any(), any()];
        corners[trial % 3][trial / 3 % 3] = WORST[trial / 9 % 3];
        corners
    };
    good.into_iter().enumerate().flat_map(|(trial, corners)| [broken(trial), corners]).collect()
}

/// Before each of these the same with one coordinate that is NaN.
pub fn with_holes(good: Vec<Corners>) -> Vec<Corners> {
    let broken = |(trial, mut corners): (usize, Corners)| {
        corners[trial % 3][trial / 3 % 3] = f32::NAN;
        corners
    };
    good.into_iter().enumerate().flat_map(|(trial, it)| [broken((trial, it)), it]).collect()
}
