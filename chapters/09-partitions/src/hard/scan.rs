//! AC-01, AC-05, AC-06, AC-10 and AC-11: what a structure finds is what the linear scan finds.

use std::sync::LazyLock;

use boxes::slab::BoxRay;
use common::sampler::Stream;
use common::tally::Off;
use ray_casting::ray::Ray;
use triangles::brute::Found;

use super::rays::{KINDS, around, ray, t_max};
use super::scenes::{Answer, SCENES, Scene, bits, soup, with_garbage, with_holes};
use crate::accelerator::Accelerator;
use crate::naive::{Stop, along_a_line, along_a_line_in_a_tree, bounds, octree_by_centroids};
use crate::octree::Octree;
use crate::scan::Scan;

/// The scene and ray of a trial, and the limit for hits.
fn draw(trial: u64) -> Option<(&'static Scene, Ray, f32)> {
    let mut stream = Stream::of_trial(900, trial);
    let count = SCENES.len() as u64;
    let scene = &SCENES[(trial % count) as usize];
    let ray = ray(scene, trial / count % KINDS, &mut stream)?;
    Some((scene, ray, t_max(&mut stream, around(scene).size().max_element())))
}

fn scanned(scene: &Scene, ray: &Ray) -> Option<Found> {
    scene.scan.nearest(ray, f32::INFINITY, &mut Off)
}

/// Whether a grid walked along a line, until the first hit, finds something else.
pub(super) fn any_naive(trial: u64) -> bool {
    draw(trial).is_some_and(|(scene, ray, _)| {
        let found = along_a_line(&scene.grid, &ray, Stop::AtFirstHit);
        bits(found) != bits(scanned(scene, &ray))
    })
}

/// Whether any structure finds something else. One of them is also asked whether there is any hit.
pub(super) fn any_robust(trial: u64) -> bool {
    draw(trial).is_some_and(|(scene, ray, t_max)| {
        let expected = scene.scan.nearest(&ray, t_max, &mut Off);
        let is_hit = scene.is_hit((trial % 5) as usize, &ray, t_max);
        is_hit != expected.is_some()
            || scene.found(&ray, t_max).iter().any(|found| bits(*found) != bits(expected))
    })
}

/// Scenes of good triangles and others with corners that are NaN or infinite, and the scan of the
/// good ones alone.
static GARBAGE: LazyLock<Vec<(Scene, Scan)>> = LazyLock::new(|| {
    let scene = |count: u64| {
        let spoil = if count % 2 == 0 { with_garbage } else { with_holes };
        (Scene::new(spoil(soup(count))), Scan::build(soup(count)))
    };
    (1..24).map(scene).collect()
});

/// The scene of a trial, the scan of what is good in it, and a ray.
fn among_garbage(trial: u64) -> Option<(&'static Scene, &'static Scan, Ray)> {
    let mut stream = Stream::of_trial(905, trial);
    let (scene, good) = &GARBAGE[(trial % GARBAGE.len() as u64) as usize];
    Some((scene, good, ray(scene, trial % 4, &mut stream)?))
}

/// Whether a box around everything keeps a ray from a good triangle.
pub(super) fn garbage_naive(trial: u64) -> bool {
    among_garbage(trial).is_some_and(|(scene, good, ray)| {
        let bounds = bounds(&scene.triangles);
        let is_hit = good.nearest(&ray, f32::INFINITY, &mut Off).is_some();
        is_hit && BoxRay::new(&ray, &bounds).enter(&bounds, f32::INFINITY).is_none()
    })
}

/// Whether a structure finds something else than a good triangle, at its place among the others.
pub(super) fn garbage_robust(trial: u64) -> bool {
    among_garbage(trial).is_some_and(|(scene, good, ray)| {
        let expected = good.nearest(&ray, f32::INFINITY, &mut Off);
        let expected = expected.map(|found| Found { index: 2 * found.index + 1, ..found });
        scene.found(&ray, f32::INFINITY).iter().any(|found| bits(*found) != bits(expected))
    })
}

/// A ray through a corner of a scene whose planes coincide with walls, in a plane across an axis.
fn in_plane(trial: u64) -> Option<(&'static Scene, Ray)> {
    let mut stream = Stream::of_trial(906, trial);
    let scene = &SCENES[2 + (trial % 2) as usize];
    Some((scene, ray(scene, 4 + trial / 2 % 2, &mut stream)?))
}

pub(super) fn in_plane_naive(trial: u64) -> bool {
    in_plane(trial).is_some_and(|(scene, ray)| {
        bits(along_a_line_in_a_tree(&scene.median, &ray)) != bits(scanned(scene, &ray))
    })
}

pub(super) fn in_plane_robust(trial: u64) -> bool {
    in_plane(trial).is_some_and(|(scene, ray)| {
        let [_, _, median, sah, bsp] = scene.found(&ray, f32::INFINITY);
        [median, sah, bsp].iter().any(|found| bits(*found) != bits(scanned(scene, &ray)))
    })
}

/// A ray along an axis through a corner of a scene, its zeros of either sign.
fn along_an_axis(trial: u64) -> Option<(&'static Scene, Ray)> {
    let mut stream = Stream::of_trial(910, trial);
    let scene = &SCENES[1 + (trial % 3) as usize];
    Some((scene, ray(scene, 4, &mut stream)?))
}

pub(super) fn axis_naive(trial: u64) -> bool {
    along_an_axis(trial).is_some_and(|(scene, ray)| {
        let found = along_a_line(&scene.grid, &ray, Stop::AtHitInCell);
        bits(found) != bits(scanned(scene, &ray))
    })
}

/// Whether the grid's answer is another than the scan's, or another when -0 is made 0.
pub(super) fn axis_robust(trial: u64) -> bool {
    along_an_axis(trial).is_some_and(|(scene, ray)| {
        let positive = Ray { direction: ray.direction + 0.0, ..ray };
        let answers = [ray, positive].map(|ray| Answer::of(&scene.grid, &ray, f32::INFINITY));
        answers.iter().any(|answer| !answer.is(scanned(scene, &ray)))
    })
}

/// The scenes whose triangles meet where cells do, by triangles' boxes and by their centroids.
static STRADDLING: LazyLock<Vec<[Octree; 2]>> = LazyLock::new(|| {
    let trees = |scene: &Scene| {
        [Octree::build(scene.triangles.clone()), octree_by_centroids(&scene.triangles)]
    };
    SCENES[2..4].iter().map(trees).collect()
});

/// Whether an octree, by boxes or by centroids, misses a triangle at a cell's corner.
fn straddler_is_missed(trial: u64, by_centroids: bool) -> bool {
    let mut stream = Stream::of_trial(911, trial);
    let which = (trial % 2) as usize;
    let scene = &SCENES[2 + which];
    ray(scene, 1 + trial / 2 % 5, &mut stream).is_some_and(|ray| {
        let tree = &STRADDLING[which][usize::from(by_centroids)];
        let found = tree.nearest(&ray, f32::INFINITY, &mut Off);
        bits(found) != bits(scanned(scene, &ray))
    })
}

pub(super) fn straddling_naive(trial: u64) -> bool {
    straddler_is_missed(trial, true)
}

pub(super) fn straddling_robust(trial: u64) -> bool {
    straddler_is_missed(trial, false)
}
