//! AC-02, AC-03 and AC-04: boxes from which no tree seems to come.

use boxes::aabb::Aabb;
use common::sampler::Stream;
use glam::Vec3;

use crate::build::{DEPTH, Recipe};
use crate::naive;
use crate::split::Split;
use crate::tree::Bvh;

/// A tree takes longer than a formula: that many trials of the quicker cases,
pub(super) const LONG: u64 = 100_000;
/// and of those with more boxes.
pub(super) const LONGER: u64 = 10_000;

const SPLITS: [Split; 3] = [Split::Midpoint, Split::Median, Split::Sah];

/// Whether the tree by one of the splits, with one thing a leaf, is none.
fn flawed(trial: u64, boxes: &[Aabb]) -> bool {
    let recipe = Recipe { split: SPLITS[(trial % 3) as usize], ..Recipe::default() };
    recipe.build(boxes.iter().copied()).flaw(boxes).is_some()
}

fn point(stream: &mut Stream, side: f32) -> Vec3 {
    let x = stream.between(-side, side);
    let y = stream.between(-side, side);
    Vec3::new(x, y, stream.between(-side, side))
}

fn around(center: Vec3, half: Vec3) -> Aabb {
    Aabb { min: center - half.abs(), max: center + half.abs() }
}

/// Boxes around few centres: concentric, or copies of one another.
fn copies(trial: u64) -> Vec<Aabb> {
    let mut stream = Stream::of_trial(1002, trial);
    let (count, centers) = (2 + trial % 9, 1 + trial / 9 % 4);
    let center = |number: u64| point(&mut Stream::of_trial(trial, number), 8.0).round();
    let half = Vec3::new(1.0, 2.0, 3.0);
    let next = |number: u64| {
        let size = if trial.is_multiple_of(2) { 1.0 } else { (stream.bits() % 7) as f32 };
        around(center(number % centers), size * half)
    };
    (0..count).map(next).collect()
}

pub(super) fn copies_naive(trial: u64) -> bool {
    let centers: Vec<Vec3> = copies(trial).iter().map(Aabb::center).collect();
    naive::midpoint_depth(&centers).is_none()
}

pub(super) fn copies_robust(trial: u64) -> bool {
    flawed(trial, &copies(trial))
}

/// A few boxes whose coordinates have so few digits that every power of two below leaves them exact.
fn few(trial: u64, scale: f32) -> Vec<Aabb> {
    let mut stream = Stream::of_trial(1003, trial);
    let mut next = || {
        let center = point(&mut stream, 200.0).round();
        around(center, point(&mut stream, 20.0).round())
    };
    let boxes: Vec<Aabb> = (0..9).map(|_| next()).collect();
    boxes.iter().map(|it| Aabb { min: scale * it.min, max: scale * it.max }).collect()
}

/// 2^-100 to 2^100.
fn scale(trial: u64) -> f32 {
    f32::from_bits(((27 + trial % 201) as u32) << 23)
}

/// Whether the textbook chooses another plane because all is larger or smaller.
pub(super) fn scale_naive(trial: u64) -> bool {
    naive::cheapest_plane(&few(trial, scale(trial))) != naive::cheapest_plane(&few(trial, 1.0))
}

/// Whether the tree is another one, but for its boxes' sizes.
pub(super) fn scale_robust(trial: u64) -> bool {
    let recipe = Recipe::default();
    let shape = |tree: &Bvh| -> Vec<(u32, u32)> {
        tree.nodes.iter().map(|node| (node.first, node.count)).collect()
    };
    let [scaled, plain] = [scale(trial), 1.0].map(|scale| recipe.build(few(trial, scale)));
    scaled.order != plain.order || shape(&scaled) != shape(&plain)
}

/// Boxes on one axis, each a fraction as far from the origin as the one before.
fn progression(trial: u64) -> Vec<Aabb> {
    let axis = (trial % 3) as usize;
    let ratio = [0.5, 0.25, 0.4][(trial / 3 % 3) as usize];
    let count = 66 + trial / 9 % 100;
    let mut place = if trial.is_multiple_of(2) { 1e30 } else { -1e19 };
    let mut next = || {
        place *= ratio;
        let mut center = Vec3::ZERO;
        center[axis] = place;
        around(center, 0.1 * center)
    };
    (0..count).map(|_| next()).collect()
}

/// Whether the textbook's tree is deeper than the stack is high, or never ends.
pub(super) fn progression_naive(trial: u64) -> bool {
    let centers: Vec<Vec3> = progression(trial).iter().map(Aabb::center).collect();
    naive::midpoint_depth(&centers).is_none_or(|depth| depth > DEPTH)
}

pub(super) fn progression_robust(trial: u64) -> bool {
    flawed(trial / 27, &progression(trial))
}
